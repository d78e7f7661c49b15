// Rapier 0.21 [manual: rapier.rs/docs]: bodies and joints held by velocities, or by joints as coordinates, in
// float.
//
// A body's axes are here the world's at the start, and its moments have axes of their own: so a joint's axis
// has the same numbers in both bodies.

import RAPIER from '@dimforge/rapier3d-compat';

import { NotExpressible, after, ground, isZero, minus, start } from './simulation.mjs';

await RAPIER.init();

const { JointAxesMask, JointData } = RAPIER;
const xyz = ([x, y, z]) => ({ x, y, z });
const wxyz = ([w, x, y, z]) => ({ w, x, y, z });
const list = ({ x, y, z }) => [x, y, z];

class InRapier {
  constructor(world, variant, step) {
    this.variant = variant;
    this.starts = world.bodies.map((b) => b.start);
    this.world = new RAPIER.World(xyz(world.gravity));
    this.world.timestep = step;
    if (variant === '16 substeps') this.world.numSolverIterations = 16;
    this.ground = this.world.createRigidBody(RAPIER.RigidBodyDesc.fixed());
    this.bodies = world.bodies.map((b) => this.body(b, world));
    this.pushed = new Set();
    this.jointed = new Set();
    if (!isZero(world.floor)) {
      const below = new RAPIER.ColliderDesc(new RAPIER.HalfSpace(xyz(world.floor)));
      this.touching(below, this.ground, world);
    }
    for (const joint of world.joints) this.joint(world, joint);
    for (const spring of world.springs) {
      const { stiffness, rest, end } = spring;
      this.link(JointData.spring(rest, stiffness, 0, ...this.ends(world, spring, end)), spring);
    }
  }
  free() { this.world.free(); }

  setGravity(g) { this.world.gravity = xyz(g); }
  push(body, force, at) {
    this.of(body).addForceAtPoint(xyz(force), xyz(at), true);
    this.pushed.add(body);
  }
  step() {
    this.world.step();
    for (const body of this.pushed) this.of(body).resetForces(false);
    for (const body of this.pushed) this.of(body).resetTorques(false);
    this.pushed.clear();
  }
  state(body) {
    const b = this.of(body), { w, x, y, z } = b.rotation();
    return {
      position: list(b.translation()),
      orientation: after([w, x, y, z], this.starts[body].orientation),
      velocity: list(b.linvel()),
      spin: list(b.angvel()),
    };
  }
  hasSprings() { return true; }
  save() {
    this.saved = this.world.takeSnapshot();
    return true;
  }
  restore() {
    this.world.free();
    this.world = RAPIER.World.restoreSnapshot(this.saved);
    this.bodies = this.bodies.map((b) => this.world.getRigidBody(b.handle));
  }

  of(body) { return body === ground ? this.ground : this.bodies[body]; }

  body({ mass, inertia, start: { position, orientation, velocity, spin }, shape }, world) {
    const body = this.world.createRigidBody(RAPIER.RigidBodyDesc.dynamic()
      .setTranslation(...position).setLinvel(...velocity).setAngvel(xyz(spin))
      .setAdditionalMassProperties(mass, xyz([0, 0, 0]), xyz(inertia), wxyz(orientation))
      .setCanSleep(this.variant === 'defaults'));
    if (shape.kind !== 'none') {
      const { ball, cuboid } = RAPIER.ColliderDesc;
      const touching = shape.kind === 'ball' ? ball(shape.half[0]) : cuboid(...shape.half);
      this.touching(touching.setRotation(wxyz(orientation)).setDensity(0), body, world);
    }
    return body;
  }
  touching(shape, body, { friction, restitution }) {
    this.world.createCollider(shape.setFriction(friction).setRestitution(restitution), body);
  }
  ends(world, { a, b, at }, end = at) {
    return [minus(at, start(world, a).position), minus(end, start(world, b).position)].map(xyz);
  }
  link(data, { a, b }) { this.world.createImpulseJoint(data, this.of(a), this.of(b), true); }

  joint(world, joint) {
    const { LinX, LinY, LinZ, AngY, AngZ } = JointAxesMask, { kind, a, b, at, axis, end } = joint;
    const ends = this.ends(world, joint);
    if (kind === 'rod') {
      this.link(JointData.rope(Math.hypot(...minus(end, at)), ...this.ends(world, joint, end)), joint);
      return;
    }
    const data = kind === 'ball' ? JointData.spherical(...ends)
      : JointData.generic(...ends, xyz(axis), (kind === 'hinge' ? LinX : 0) | LinY | LinZ | AngY | AngZ);
    if (this.variant !== 'joints as coordinates') {
      this.link(data, joint);
      return;
    }
    if (this.jointed.has(b)) throw new NotExpressible('a loop of joints as coordinates');
    if (!isZero(world.bodies[b].start.velocity) || !isZero(world.bodies[b].start.spin))
      throw new NotExpressible('joints as coordinates start at rest');
    this.jointed.add(b);
    this.world.createMultibodyJoint(data, this.of(a), this.of(b), true);
  }
}

export const about = {
  name: 'Rapier',
  version: RAPIER.version(),
  precision: 'float',
};

export const make = (world, variant, step) => new InRapier(world, variant, step);
