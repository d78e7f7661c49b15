// Box2D 3 as box2d3-wasm 5.2 [manual: box2d.org/documentation]: the plane in float, bodies and joints by
// velocity constraints in substeps.

import initBox2d from 'box2d3-wasm';

import {
  aboutZ, angle, cross, expectInPlane, ground, installedVersion, isZero, minus, pointIn, start,
} from './simulation.mjs';

const b2 = await initBox2d();

const vector = ([x, y]) => new b2.b2Vec2(x, y);
/// Replaces b2MakeRot, whose sine is off by up to 1.7e-3.
const turn = (angle) => Object.assign(new b2.b2Rot(), { c: Math.cos(angle), s: Math.sin(angle) });
/// Reads a value owned by Box2D, which we have to delete.
function read(value, f) {
  const read = f(value);
  value.delete();
  return read;
}
const xy0 = (value) => read(value, ({ x, y }) => [x, y, 0]);

class InBox2d {
  constructor(world, variant) {
    expectInPlane(world);
    this.best = variant !== 'defaults';
    this.substeps = this.best ? 16 : 4;
    const def = Object.assign(b2.b2DefaultWorldDef(), { gravity: vector(world.gravity) });
    if (this.best) Object.assign(def, { enableSleep: false, restitutionThreshold: 0 });
    this.id = b2.b2CreateWorld(def);
    this.ground = b2.b2CreateBody(this.id, b2.b2DefaultBodyDef());
    this.bodies = world.bodies.map((b) => this.body(world, b));
    for (const joint of world.joints) this.joint(world, joint);
    if (!isZero(world.floor)) {
      const along = cross(world.floor, [0, 0, 1000]), segment = new b2.b2Segment();
      Object.assign(segment, { point1: vector(along), point2: vector(minus([0, 0, 0], along)) });
      b2.b2CreateSegmentShape(this.ground, this.shape(world), segment);
    }
  }
  free() { b2.b2DestroyWorld(this.id); }

  setGravity(g) { read(vector(g), (g) => b2.b2World_SetGravity(this.id, g)); }
  push(body, force, at) {
    read(vector(force), (f) => read(vector(at), (p) => b2.b2Body_ApplyForce(this.of(body), f, p, true)));
  }
  step(seconds) { b2.b2World_Step(this.id, seconds, this.substeps); }
  state(body) {
    const id = this.of(body), angle = read(b2.b2Body_GetRotation(id), ({ c, s }) => Math.atan2(s, c));
    return {
      position: xy0(b2.b2Body_GetPosition(id)),
      orientation: aboutZ(angle),
      velocity: xy0(b2.b2Body_GetLinearVelocity(id)),
      spin: [0, 0, b2.b2Body_GetAngularVelocity(id)],
    };
  }

  of(body) { return body === ground ? this.ground : this.bodies[body]; }

  body(world, { mass, inertia, start: { position, orientation, velocity, spin }, shape: { kind, half } }) {
    const body = b2.b2CreateBody(this.id, Object.assign(b2.b2DefaultBodyDef(), {
      type: b2.b2BodyType.b2_dynamicBody,
      position: vector(position),
      rotation: turn(angle(orientation)),
      linearVelocity: vector(velocity),
      angularVelocity: spin[2],
      allowFastRotation: this.best,
    }));
    if (kind === 'ball')
      b2.b2CreateCircleShape(body, this.shape(world), Object.assign(new b2.b2Circle(), { radius: half[0] }));
    if (kind === 'box') b2.b2CreatePolygonShape(body, this.shape(world), b2.b2MakeBox(half[0], half[1]));
    b2.b2Body_SetMassData(body,
      Object.assign(new b2.b2MassData(), { mass, center: vector([0, 0]), rotationalInertia: inertia[2] }));
    return body;
  }
  shape({ friction, restitution }) {
    const def = b2.b2DefaultShapeDef();
    def.material = Object.assign(new b2.b2SurfaceMaterial(), { friction, restitution });
    return def;
  }

  joint(world, { kind, a, b, at, axis, end }) {
    const [type, far] = { rod: ['Distance', end], cylinder: ['Prismatic', at] }[kind] ?? ['Revolute', at];
    const def = b2[`b2Default${type}JointDef`]();
    const frame = (body, at) => Object.assign(new b2.b2Transform(), {
      p: vector(pointIn(start(world, body), at)),
      q: turn((kind === 'cylinder' ? Math.atan2(axis[1], axis[0]) : 0) -
        angle(start(world, body).orientation)),
    });
    def.base = Object.assign(def.base, {
      bodyIdA: this.of(a), bodyIdB: this.of(b), localFrameA: frame(a, at), localFrameB: frame(b, far),
    });
    if (kind === 'rod') def.length = Math.hypot(...minus(end, at));
    b2[`b2Create${type}Joint`](this.id, def);
  }
}

const version = `box2d3-wasm ${installedVersion('box2d3-wasm')}`;
export const about = { name: 'Box2D 3', version, precision: 'float', plane: true };

export const make = (world, variant) => new InBox2d(world, variant);
