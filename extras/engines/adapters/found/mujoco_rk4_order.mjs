// MuJoCo 3.14: RK4 is of second order in space.
//
// Its RK4 has order 4 in the angle of a hinge, and order 2 in a body that turns freely. The spins of its four
// stages are averaged in the body's axes, which turn meanwhile. Prints the errors of both relative to 61440
// Hz.
//   node found/mujoco_rk4_order.mjs

import loadMujoco from '@mujoco/mujoco';

const mujoco = await loadMujoco();
const scenes = {
  'a pendulum': ['<joint type="hinge" axis="0 1 0" pos="0 0 1"/>', [2]],
  'a free body': ['<freejoint/>', [0, 0, 0, 0.1, 2, 0.1]],
};

function end(joint, start, hertz) {
  const model = mujoco.MjModel.from_xml_string(`<mujoco><option timestep="${1 / hertz}" integrator="RK4"
    gravity="0 0 ${joint === '<freejoint/>' ? 0 : -9.81}"/><worldbody><body>
    <inertial pos="0 0 0" mass="1" diaginertia="1 2 3"/>${joint}</body></worldbody></mujoco>`);
  const data = new mujoco.MjData(model);
  data.qvel.set(start);
  for (let step = 0; step < 2 * hertz; ++step) mujoco.mj_step(model, data);
  return [...data.qpos];
}

for (const [name, [joint, start]] of Object.entries(scenes)) {
  const truth = end(joint, start, 61440);
  const errors = [30, 60, 120, 240].map((hertz) =>
    Math.hypot(...end(joint, start, hertz).map((x, i) => x - truth[i])));
  const orders = errors.slice(1).map((e, i) => Math.log2(errors[i] / e).toFixed(2));
  console.log(`${name}: ${errors.map((e) => e.toExponential(1)).join(', ')}: order ${orders.join(', ')}`);
}
