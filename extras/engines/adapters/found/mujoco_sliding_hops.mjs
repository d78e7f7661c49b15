// MuJoCo 3.14: a sliding box leaves the floor.
//
// A box that slides on a floor at 2 m/s leaves it, the higher the longer the step and the stiffer the
// contact. Friction is a convex problem, in which a slide may go along the cone, away from the floor, at up
// to friction times 2 m/s. That is 18 mm of height for a friction of 0.3. Without friction it stays.
//   node found/mujoco_sliding_hops.mjs

import loadMujoco from '@mujoco/mujoco';

const mujoco = await loadMujoco();

function hop({ friction = 0.3, hertz = 60, solref = '0.02 1', depth = 0, cone = 'pyramidal' }) {
  const model = mujoco.MjModel.from_xml_string(`<mujoco><option timestep="${1 / hertz}" cone="${cone}"/>
    <default><geom friction="${friction} 0 0" solref="${solref}"/></default>
    <worldbody><geom type="plane" size="9 9 1"/><body pos="0 0 ${0.1 - depth}"><freejoint/>
    <geom type="box" size="0.3 0.2 0.1" mass="1"/></body></worldbody></mujoco>`);
  const data = new mujoco.MjData(model);
  data.qvel[0] = 2;
  let highest = 0;
  for (let step = 0; step < hertz; ++step) {
    mujoco.mj_step(model, data);
    highest = Math.max(highest, data.qpos[2] - 0.1);
  }
  return `${(1000 * highest).toFixed(2)} mm`;
}

for (const settings of [{}, { friction: 0.6 }, { friction: 0 }, { depth: 1e-4 }, { cone: 'elliptic' },
  { hertz: 500 }, { hertz: 500, depth: 1e-4 }, { hertz: 500, solref: '0.004 1' }])
  console.log(`${JSON.stringify(settings)}: ${hop(settings)}`);
