// MuJoCo 3.14 [manual: mujoco.readthedocs.io]: a tree of bodies in joint coordinates, contacts as springs
// with dampers, in double.

import loadMujoco from '@mujoco/mujoco';

import { xml } from './mujoco_xml.mjs';
import { NotExpressible, back, dot, isZero, minus, start, turned } from './simulation.mjs';

const mujoco = await loadMujoco();
const whole = mujoco.mjtState.mjSTATE_INTEGRATION.value, aBody = mujoco.mjtObj.mjOBJ_BODY.value,
  aJoint = mujoco.mjtObj.mjOBJ_JOINT.value;

/// Speed of the slide at the start.
function slideSpeed(world, { a, b, axis }) {
  return dot(axis, minus(start(world, b).velocity, start(world, a).velocity));
}

class InMujoco {
  constructor(world, variant, step) {
    if (world.restitution !== 0 && !isZero(world.floor))
      throw new NotExpressible('no coefficient of restitution: contacts are springs with dampers');
    const integrator = variant === 'defaults' ? '' : `integrator="${variant}"`;
    this.model = mujoco.MjModel.from_xml_string(xml(world, `timestep="${step}" ${integrator}`));
    this.data = new mujoco.MjData(this.model);
    this.motion = new mujoco.DoubleBuffer(6);
    this.ids = world.bodies.map((_, body) => mujoco.mj_name2id(this.model, aBody, `${body}`));
    this.setGravity(world.gravity);
    this.setOff(world);
  }
  free() { [this.model, this.data, this.motion, this.saved].forEach((one) => one?.delete()); }

  setGravity(g) { this.model.opt.gravity.set(g); }
  push(body, force, at) { this.apply(body, force, [0, 0, 0], at); }
  /// Where a step diverges, the data are reset to time 0.
  step() {
    const { time } = this.data;
    mujoco.mj_step(this.model, this.data);
    this.diverged ||= this.data.time <= time;
    this.data.qfrc_applied.fill(0);
    this.seen = false;
  }
  state(body) {
    this.see();
    const { model, data, motion } = this, id = this.ids[body];
    mujoco.mj_objectVelocity(model, data, aBody, id, motion, 0);
    const [p, q, r, x, y, z] = motion.GetView();
    return {
      position: [...data.xpos.subarray(3 * id, 3 * id + 3)],
      orientation: [...data.xquat.subarray(4 * id, 4 * id + 4)],
      velocity: this.diverged ? [NaN, NaN, NaN] : [x, y, z],
      spin: [p, q, r],
    };
  }
  hasSprings() { return true; }
  save() {
    this.saved = new mujoco.DoubleBuffer(mujoco.mj_stateSize(this.model, whole));
    mujoco.mj_getState(this.model, this.data, this.saved, whole);
    return true;
  }
  restore() {
    mujoco.mj_setState(this.model, this.data, this.saved.GetView(), whole);
    this.seen = false;
  }

  /// Sets the joints' velocities from the bodies' momenta.
  setOff(world) {
    const { model, data } = this;
    mujoco.mj_forward(model, data);
    world.bodies.forEach(({ mass, inertia, start: { position, orientation, velocity, spin } }, body) => {
      const along = turned(back(orientation), spin).map((w, i) => inertia[i] * w);
      this.apply(body, velocity.map((v) => mass * v), turned(orientation, along), position);
    });
    for (const joint of world.joints)
      if (joint.kind === 'slide')
        data.qfrc_applied[model.jnt_dofadr[mujoco.mj_name2id(model, aJoint, `${joint.b}`)]] +=
          joint.wheel * slideSpeed(world, joint);
    mujoco.mj_solveM(model, data, data.qvel, data.qfrc_applied);
    data.qfrc_applied.fill(0);
    this.seen = false;
  }
  apply(body, force, torque, at) {
    this.see();
    mujoco.mj_applyFT(this.model, this.data, force, torque, at, this.ids[body], this.data.qfrc_applied);
  }
  /// Updates the bodies' places, which lag a step behind otherwise.
  see() {
    if (this.seen) return;
    for (const f of [mujoco.mj_kinematics, mujoco.mj_comPos, mujoco.mj_comVel]) f(this.model, this.data);
    this.seen = true;
  }
}

const version = mujoco.mj_versionString();
export const about = { name: 'MuJoCo', version, precision: 'double', ropes: true };

export const make = (world, variant, step) => new InMujoco(world, variant, step);
