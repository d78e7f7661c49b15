// Jolt 1.1: damping, a cap on spins, no gyroscopic forces.
//
// A body of moments 1, 2, 3 kg m^2 that spins freely about the middle axis keeps it, as gyroscopic forces are
// left out. It loses 5 % of its spin and of its speed each second, and spins at 47 rad/s at most.
//   node found/jolt_defaults.mjs

import { make } from '../jolt.mjs';

const zero = [0, 0, 0];
const world = (spin) => ({
  gravity: zero, floor: zero, joints: [], springs: [],
  bodies: [{ mass: 1, inertia: [1, 2, 3], shape: { kind: 'none' },
    start: { position: zero, orientation: [1, 0, 0, 0], velocity: [1, 0, 0], spin } }],
});

for (const spin of [[0.01, 5, 0], [0.01, 60, 0]])
  for (const variant of ['defaults', 'nothing left out']) {
    const simulation = make(world(spin), variant);
    for (let step = 0; step < 2400; ++step) simulation.step(1 / 960);
    const { velocity, spin: now, orientation: [w, x, y, z] } = simulation.state(0);
    const tilt = Math.acos(1 - 2 * (x * x + z * z)) * 180 / Math.PI;
    console.log(`${spin} rad/s, ${variant}: after 2.5 s ${Math.hypot(...now).toFixed(2)} rad/s, ` +
      `${velocity[0].toFixed(3)} m/s, the middle axis ${tilt.toFixed(1)} degrees from where it was`);
  }
