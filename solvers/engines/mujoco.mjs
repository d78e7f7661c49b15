// MuJoCo 3.14 [manual: mujoco.readthedocs.io]: a tree of bodies in the coordinates of its joints, contacts as
// springs with dampers, in double.

import loadMujoco from '@mujoco/mujoco';

import {
  NotExpressible, after, back, beside, cross, directionIn, dot, ground, isZero, minus, pointIn, start, turned,
  unit,
} from './simulation.mjs';

const mujoco = await loadMujoco();
const whole = mujoco.mjtState.mjSTATE_INTEGRATION.value, aBody = mujoco.mjtObj.mjOBJ_BODY.value,
  aJoint = mujoco.mjtObj.mjOBJ_JOINT.value;

const numbers = (list) => list.join(' ');

/// Which joint hangs each body on another or on the ground; none: it is free.
function hangers(world) {
  const hangers = new Map(), open = [...world.joints];
  const grow = (parent) => {
    for (const joint of [...open]) {
      const { kind, a, b, at, end } = joint;
      if (!open.includes(joint) || (a !== parent && b !== parent)) continue;
      open.splice(open.indexOf(joint), 1);
      const turned = kind === 'rod' ? { a: b, b: a, at: end, end: at } : { a: b, b: a };
      hang(a === parent ? joint : { ...joint, ...turned });
    }
  };
  const hang = (joint) => {
    if (joint.b === ground || hangers.has(joint.b))
      throw new NotExpressible('a loop of joints: bodies are a tree');
    hangers.set(joint.b, joint);
    grow(joint.b);
  };
  grow(ground);
  world.bodies.forEach((_, body) => {
    if (!hangers.has(body)) hangers.set(body, undefined), grow(body);
  });
  return hangers;
}

/// A slide's coordinate. A tendon's length of -1 would mean none given: here lengths are far from that.
const slideAtStart = (body) => 100 * (1 + body);

/// What a slide turns is its armature. A rod is two hinges across it at its one end and a ball joint at its
/// other: it has no mass.
function joints({ kind, b, at, axis, end, wheel }, s) {
  const one = (type, at, axis, more = '') =>
    `<joint type="${type}" ${more} pos="${numbers(pointIn(s, at))}"
      axis="${numbers(directionIn(s, axis))}"/>`;
  if (kind === 'cylinder') return one('slide', at, axis) + one('hinge', at, axis);
  if (kind === 'slide')
    return one(kind, at, axis, `name="${b}" ref="${slideAtStart(b)}" armature="${wheel}"`);
  if (kind !== 'rod') return one(kind, at, axis);
  const rod = unit(minus(end, at)), across = beside(rod);
  return one('hinge', at, across) + one('hinge', at, cross(rod, across)) + one('ball', end, rod);
}

/// At the start.
function slideSpeed(world, { a, b, axis }) {
  return dot(axis, minus(start(world, b).velocity, start(world, a).velocity));
}

/// The world in MuJoCo's own language.
function xml(world, options) {
  const held = hangers(world), touching = `friction="${world.friction} 0 0"`;
  const sites = (body) => world.springs.map(({ a, b, at, end }, i) => {
    const site = (name, place) =>
      `<site name="${name}${i}" pos="${numbers(pointIn(start(world, body), place))}"/>`;
    return (a === body ? site('a', at) : '') + (b === body ? site('b', end) : '');
  }).join('');
  const on = (parent) => sites(parent) + [...held].map(([body, hanger]) =>
    (hanger?.a ?? ground) === parent ? hung(body, hanger, start(world, parent)) : '').join('');
  const hung = (body, hanger, parent) => {
    const { mass, inertia, shape: { kind, half }, start: s } = world.bodies[body];
    const geom = `<geom type="${kind === 'ball' ? 'sphere' : 'box'}" size="${numbers(half)}" ${touching}/>`;
    return `<body name="${body}" pos="${numbers(pointIn(parent, s.position))}"
      quat="${numbers(after(back(parent.orientation), s.orientation))}">
      <inertial pos="0 0 0" mass="${mass}" diaginertia="${numbers(inertia)}"/>
      ${hanger ? joints(hanger, s) : '<freejoint/>'}${kind === 'none' ? '' : geom}${on(body)}</body>`;
  };
  const floor = `<geom type="plane" size="1 1 1" zaxis="${numbers(world.floor)}" ${touching}/>`;
  const springs = world.springs.map(({ stiffness, rest }, i) => `<spatial stiffness="${stiffness}"
    springlength="${rest}"><site site="a${i}"/><site site="b${i}"/></spatial>`);
  const ropes = world.ropes.map(({ parts, length, stiffness, rest }) => {
    const atStart = parts.reduce((sum, { body, factor }) => sum + factor * slideAtStart(body), 0);
    const slides = parts.map(({ body, factor }) => `<joint joint="${body}" coef="${factor}"/>`);
    return `<fixed stiffness="${stiffness}" springlength="${rest - length + atStart}">
      ${slides.join('')}</fixed>`;
  });
  return `<mujoco><option ${options}/><worldbody>${isZero(world.floor) ? '' : floor}${on(ground)}</worldbody>
    <tendon>${springs.join('')}${ropes.join('')}</tendon></mujoco>`;
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
  /// Where a step diverges, the data start anew at time 0.
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

  /// The joints' velocities are those that give the bodies their momenta.
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
  /// After a step the bodies are where they were before it, until their places are asked for.
  see() {
    if (this.seen) return;
    for (const f of [mujoco.mj_kinematics, mujoco.mj_comPos, mujoco.mj_comVel]) f(this.model, this.data);
    this.seen = true;
  }
}

export const about = {
  name: 'MuJoCo',
  version: mujoco.mj_versionString(),
  precision: 'double',
  ropes: true,
};

export const make = (world, variant, step) => new InMujoco(world, variant, step);
