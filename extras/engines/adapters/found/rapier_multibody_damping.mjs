// Rapier 0.21: joints as coordinates are damped unasked.
//
// A joint in reduced coordinates damps by 0.1 N m s, which JavaScript cannot switch off. Prints the amplitude
// of the same pendulum with both kinds of joints, after each swing to and fro.
//   node found/rapier_multibody_damping.mjs

import RAPIER from '@dimforge/rapier3d-compat';

await RAPIER.init();
const zero = { x: 0, y: 0, z: 0 }, upright = { x: 0, y: 0, z: 0, w: 1 };

for (const create of ['createImpulseJoint', 'createMultibodyJoint']) {
  const world = new RAPIER.World({ x: 0, y: -9.81, z: 0 });
  world.timestep = 1 / 960;
  const ground = world.createRigidBody(RAPIER.RigidBodyDesc.fixed());
  const angle = 0.5, at = { x: Math.sin(angle), y: -Math.cos(angle), z: 0 };
  const ball = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(at.x, at.y, at.z)
    .setAdditionalMassProperties(1, zero, { x: 0.01, y: 0.01, z: 0.01 }, upright));
  const joint = RAPIER.JointData.revolute(zero, { x: -at.x, y: -at.y, z: 0 }, { x: 0, y: 0, z: 1 });
  world[create](joint, ground, ball, true);
  const amplitudes = [];
  for (let step = 0, before = 0, x = at.x; step < 10 * 960; ++step) {
    world.step();
    const now = ball.translation().x;
    if (x > before && x > now) amplitudes.push(Math.asin(x).toFixed(4));
    [before, x] = [x, now];
  }
  console.log(`${create}: ${amplitudes.join(' ')}`);
}
