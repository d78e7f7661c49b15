// Box2D 3: joints are springs, however short the step.
//
// A joint is a spring of 60 Hz with the masses that it joins, whatever the step. Here a rod of 1 m carries 1
// kg at its end, from which 100 kg hang: it is 7 mm too long.
//   node found/box2d_soft_joints.mjs

import { make } from '../box2d.mjs';

const zero = [0, 0, 0];
const hanging = (y, mass) => ({ mass, inertia: [1, 1, 1], shape: { kind: 'none' },
  start: { position: [0, y, 0], orientation: [1, 0, 0, 0], velocity: zero, spin: zero } });
const rod = (a, b, at, end) => ({ kind: 'rod', a, b, at: [0, at, 0], end: [0, end, 0], axis: zero });
const world = {
  gravity: [0, -9.81, 0], shaking: zero, turning: zero, floor: zero, springs: [],
  bodies: [hanging(-1, 1), hanging(-2, 100)], joints: [rod(-1, 0, 0, -1), rod(0, 1, -1, -2)],
};

console.log(`weight over stiffness: ${(101 * 9.81 / (2 * Math.PI * 60) ** 2 * 1000).toFixed(2)} mm`);
for (const hertz of [60, 240, 960, 3840]) {
  const simulation = make(world, 'defaults');
  for (let step = 0; step < 3 * hertz; ++step) simulation.step(1 / hertz);
  console.log(`${hertz} Hz: ${((-1 - simulation.state(0).position[1]) * 1000).toFixed(2)} mm longer`);
}
