// Jolt 1.1, Rapier 0.21: the wobble of a stable spin grows.
//
// A body of moments 1, 1, 2 kg m^2 spins at S about the third axis, with 1 rad/s across it, without contact:
// both should stay constant. Gyroscopic forces by explicit Euler with steps of h multiply the part across by
// exp(S^2 h t/2), until the spin has left the axis. Rapier's steps are a quarter of the given ones. The
// angular momentum is kept.
//   node found/wobbles_grow.mjs

import { make as makeJolt } from '../jolt.mjs';
import { make as makeRapier } from '../rapier.mjs';

const zero = [0, 0, 0];
const world = (spin) => ({
  gravity: zero, floor: zero, joints: [], springs: [],
  bodies: [{ mass: 1, inertia: [1, 1, 2], shape: { kind: 'none' },
    start: { position: zero, orientation: [1, 0, 0, 0], velocity: zero, spin: [1, 0, spin] } }],
});
/// Spin along the body's third axis, and across it.
const parts = ({ orientation: [w, x, y, z], spin }) => {
  const third = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
  const along = spin.reduce((sum, s, i) => sum + s * third[i], 0);
  return [along, Math.sqrt(spin.reduce((sum, s) => sum + s * s, -along * along))];
};

for (const [name, make, variant, substeps] of
  [['Jolt', makeJolt, 'nothing left out', 1], ['Rapier', makeRapier, 'defaults', 4]])
  for (const spin of [2, 5, 10])
    for (const rate of [60, 240]) {
      const simulation = make(world(spin), variant, 1 / rate);
      for (let step = 0; step < 2 * rate; ++step) simulation.step(1 / rate);
      const [along, across] = parts(simulation.state(0));
      console.log(`${name}, ${spin} and 1 rad/s, ${rate} Hz: after 2 s ${along.toFixed(2)} and ` +
        `${across.toFixed(2)} rad/s, by explicit Euler ${Math.exp(spin ** 2 / rate / substeps).toFixed(2)} across`);
      simulation.free();
    }
