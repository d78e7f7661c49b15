// Rapier 0.21 [manual: rapier.rs/docs]: bodies and joints by velocity constraints, or joints as reduced
// coordinates, in float.

import RAPIER from '@dimforge/rapier3d-compat';

import { RapierWorld, xyz } from './rapier_world.mjs';
import { after } from './simulation.mjs';

const list = ({ x, y, z }) => [x, y, z];

class InRapier {
  constructor(world, variant, step) {
    this.world = new RapierWorld(world, variant, step);
    this.starts = world.bodies.map((b) => b.start);
    this.pushed = new Set();
  }
  free() { this.world.rapier.free(); }

  setGravity(g) { this.world.rapier.gravity = xyz(g); }
  push(body, force, at) {
    this.world.of(body).addForceAtPoint(xyz(force), xyz(at), true);
    this.pushed.add(body);
  }
  step() {
    this.world.rapier.step();
    for (const body of this.pushed) this.world.of(body).resetForces(false);
    for (const body of this.pushed) this.world.of(body).resetTorques(false);
    this.pushed.clear();
  }
  state(body) {
    const b = this.world.of(body), { w, x, y, z } = b.rotation();
    return {
      position: list(b.translation()),
      orientation: after([w, x, y, z], this.starts[body].orientation),
      velocity: list(b.linvel()),
      spin: list(b.angvel()),
    };
  }
  hasSprings() { return true; }
  save() {
    this.saved = this.world.save();
    return true;
  }
  restore() { this.world.restore(this.saved); }
}

export const about = { name: 'Rapier', version: RAPIER.version(), precision: 'float' };

export const make = (world, variant, step) => new InRapier(world, variant, step);
