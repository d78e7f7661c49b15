// Box2D 3: b2MakeRot has an inexact sine.
//
// b2MakeRot approximates sine and cosine, so a body that is put at an angle gets another.
//   node found/box2d_make_rot.mjs

import initBox2d from 'box2d3-wasm';

const b2 = await initBox2d();
let [worst, where] = [0, 0];
for (let angle = -3.14; angle <= 3.14; angle += 0.001) {
  const { c, s } = b2.b2MakeRot(angle), off = Math.abs(Math.atan2(s, c) - angle);
  if (off > worst) [worst, where] = [off, angle];
}
const half = b2.b2MakeRot(0.5);
console.log(`0.5 rad: by c and s ${Math.atan2(half.s, half.c).toFixed(6)}, ` +
  `by b2Rot_GetAngle ${b2.b2Rot_GetAngle(half).toFixed(6)}`);
console.log(`at most, from -3.14 to 3.14 rad: off by ${worst.toExponential(2)} rad, at ${where.toFixed(3)}`);
