// Jolt as jolt-physics 1.1 [manual: jrouwe.github.io/JoltPhysics]: bodies and joints by velocity constraints,
// in float.

import { Jolt, JoltWorld, place, vector } from './jolt_world.mjs';
import { installedVersion } from './simulation.mjs';

const list = (v) => [v.GetX(), v.GetY(), v.GetZ()];

class InJolt {
  constructor(world, variant) {
    this.substeps = variant === '8 collision steps' ? 8 : 1;
    this.world = new JoltWorld(world, variant === 'defaults');
    this.force = vector([0, 0, 0]), this.at = place([0, 0, 0]);
    this.setGravity(world.gravity);
  }
  free() { Jolt.destroy(this.world.jolt); }

  setGravity([x, y, z]) {
    this.force.Set(x, y, z);
    this.world.system.SetGravity(this.force);
  }
  push(body, force, at) {
    this.force.Set(...force);
    this.at.Set(...at);
    const id = this.world.of(body).GetID();
    this.world.interface.AddForce(id, this.force, this.at, Jolt.EActivation_Activate);
  }
  step(seconds) { this.world.jolt.Step(seconds, this.substeps); }
  state(body) {
    const b = this.world.of(body), position = list(b.GetCenterOfMassPosition()), q = b.GetRotation();
    return {
      position,
      orientation: [q.GetW(), q.GetX(), q.GetY(), q.GetZ()],
      velocity: list(b.GetLinearVelocity()),
      spin: list(b.GetAngularVelocity()),
    };
  }
  hasSprings() { return true; }
  save() {
    this.world.system.SaveState(this.saved = new Jolt.StateRecorderImpl());
    return true;
  }
  restore() {
    this.saved.Rewind();
    this.world.system.RestoreState(this.saved);
  }
}

export const about = { name: 'Jolt', version: installedVersion('jolt-physics'), precision: 'float' };

export const make = (world, variant) => new InJolt(world, variant);
