// Rapier's bodies, joints and shapes [manual: rapier.rs/docs].
//
// A body's axes are the world's at the start, and its moments of inertia have separate axes. So a joint's
// axis has the same components in both bodies.

import RAPIER from '@dimforge/rapier3d-compat';

import { NotExpressible, ground, isZero, minus, start } from './simulation.mjs';

await RAPIER.init();

const { JointAxesMask, JointData } = RAPIER;
export const xyz = ([x, y, z]) => ({ x, y, z });
const wxyz = ([w, x, y, z]) => ({ w, x, y, z });

/// The joint's ends in the axes of its two bodies.
const ends = (world, { a, b, at }, end = at) =>
  [minus(at, start(world, a).position), minus(end, start(world, b).position)].map(xyz);

export class RapierWorld {
  constructor(world, variant, step) {
    this.rapier = new RAPIER.World(xyz(world.gravity));
    this.rapier.timestep = step;
    if (variant === '16 substeps') this.rapier.numSolverIterations = 16;
    this.surface = (shape) => shape.setFriction(world.friction).setRestitution(world.restitution);
    this.ground = this.rapier.createRigidBody(RAPIER.RigidBodyDesc.fixed());
    this.bodies = world.bodies.map((b) => this.body(b, variant === 'defaults'));
    if (!isZero(world.floor)) {
      const below = new RAPIER.ColliderDesc(new RAPIER.HalfSpace(xyz(world.floor)));
      this.rapier.createCollider(this.surface(below), this.ground);
    }
    const jointed = new Set();
    for (const joint of world.joints)
      if (variant === 'joints as coordinates' && joint.kind !== 'rod') this.coordinate(world, joint, jointed);
      else this.link(this.joint(world, joint), joint);
    for (const spring of world.springs) {
      const { stiffness, rest, end } = spring;
      this.link(JointData.spring(rest, stiffness, 0, ...ends(world, spring, end)), spring);
    }
  }

  of(body) { return body === ground ? this.ground : this.bodies[body]; }

  body({ mass, inertia, start: { position, orientation, velocity, spin }, shape: { kind, half } }, sleeps) {
    const body = this.rapier.createRigidBody(RAPIER.RigidBodyDesc.dynamic()
      .setTranslation(...position).setLinvel(...velocity).setAngvel(xyz(spin))
      .setAdditionalMassProperties(mass, xyz([0, 0, 0]), xyz(inertia), wxyz(orientation))
      .setCanSleep(sleeps));
    if (kind !== 'none') {
      const { ball, cuboid } = RAPIER.ColliderDesc;
      const shape = kind === 'ball' ? ball(half[0]) : cuboid(...half);
      this.rapier.createCollider(this.surface(shape.setRotation(wxyz(orientation)).setDensity(0)), body);
    }
    return body;
  }

  /// A rod becomes a rope, which is the same while it is taut.
  joint(world, joint) {
    const { LinX, LinY, LinZ, AngY, AngZ } = JointAxesMask, { kind, at, axis, end } = joint;
    if (kind === 'rod') return JointData.rope(Math.hypot(...minus(end, at)), ...ends(world, joint, end));
    if (kind === 'ball') return JointData.spherical(...ends(world, joint));
    const held = (kind === 'hinge' ? LinX : 0) | LinY | LinZ | AngY | AngZ;
    return JointData.generic(...ends(world, joint), xyz(axis), held);
  }
  link(data, { a, b }) { this.rapier.createImpulseJoint(data, this.of(a), this.of(b), true); }
  coordinate(world, joint, jointed) {
    const { a, b } = joint, { velocity, spin } = world.bodies[b].start;
    if (jointed.has(b)) throw new NotExpressible('a loop of joints as coordinates');
    if (!isZero(velocity) || !isZero(spin)) throw new NotExpressible('joints as coordinates start at rest');
    jointed.add(b);
    this.rapier.createMultibodyJoint(this.joint(world, joint), this.of(a), this.of(b), true);
  }

  save() { return this.rapier.takeSnapshot(); }
  restore(saved) {
    this.rapier.free();
    this.rapier = RAPIER.World.restoreSnapshot(saved);
    this.bodies = this.bodies.map((b) => this.rapier.getRigidBody(b.handle));
  }
}
