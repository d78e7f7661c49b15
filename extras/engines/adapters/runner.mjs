// runner.cpp for the engines that run in WebAssembly:
//   node runner.mjs rapier --about     its description
//   node runner.mjs rapier             reads one request (world_json.hpp), writes one reply.
// An adapter, NAME.mjs, exports `about`, with `plane` and `ropes` where they are true, and `make(world,
// variant, step)`. `make` returns a simulation as in simulation.hpp, or throws NotExpressible. hasSprings,
// save and restore are optional. free() is required, as nothing else destroys the WebAssembly objects.

import { readFileSync } from 'node:fs';
import { performance } from 'node:perf_hooks';

import {
  NotExpressible, cross, ground, isZero, minus, plus, pointIn, settings, start, times, turned,
} from './simulation.mjs';

const engines = Object.keys(settings)
  .filter((file) => file.endsWith('.mjs'))
  .map((file) => file.slice(0, -'.mjs'.length));

const whereNow = (simulation, { body, inBody }) => {
  if (body === ground) return inBody;
  const { position, orientation } = simulation.state(body);
  return plus(position, turned(orientation, inBody));
};

/// Forces that the engine does not compute: the world's springs, and the forces of its moving axes.
class Pushes {
  constructor(world) {
    this.world = world;
    this.ends = world.springs.map((s) => [[s.a, s.at], [s.b, s.end]].map(
      ([body, at]) => ({ body, inBody: pointIn(start(world, body), at) })));
    this.shaken = !isZero(world.shaking);
    this.turning = !isZero(world.turning);
  }

  beforeStep(simulation, t) {
    const { gravity, shaking, frequency, springs, bodies } = this.world;
    if (this.shaken) simulation.setGravity(plus(gravity, times(Math.sin(frequency * t), shaking)));
    if (!simulation.hasSprings?.())
      springs.forEach((spring, i) => this.pull(simulation, spring, this.ends[i]));
    if (this.turning) bodies.forEach((_, i) => this.turn(simulation, i));
  }

  pull(simulation, spring, ends) {
    const a = whereNow(simulation, ends[0]), b = whereNow(simulation, ends[1]), along = minus(b, a);
    const force = times(spring.stiffness * (1 - spring.rest / Math.hypot(...along)), along);
    if (spring.a !== ground) simulation.push(spring.a, force, a);
    if (spring.b !== ground) simulation.push(spring.b, times(-1, force), b);
  }

  turn(simulation, body) {
    const { position, velocity } = simulation.state(body), w = this.world.turning;
    const acceleration = minus(times(-2, cross(w, velocity)), cross(w, cross(w, position)));
    simulation.push(body, times(this.world.bodies[body].mass, acceleration), position);
  }
}

const numbers = (frame) => frame.flatMap((s) => [...s.position, ...s.orientation, ...s.velocity, ...s.spin]);

/// One run of a request, with its states at the frames.
class Run {
  constructor(make, request) {
    this.request = request;
    this.h = 1 / (request.frames_per_second * request.steps_per_frame);
    this.simulation = make(request.world, request.variant, this.h);
    this.pushes = new Pushes(request.world);
    this.seconds = 0;
    this.frame = 0;
    this.frames = [];
    this.see();
  }

  /// Continues as long as the states are finite.
  toFrame(frame) {
    const steps = this.request.steps_per_frame;
    for (; this.frame < frame && this.finite; ++this.frame) {
      const begin = performance.now();
      for (let i = 0; i < steps; ++i) {
        this.pushes.beforeStep(this.simulation, (this.frame * steps + i) * this.h);
        this.simulation.step(this.h);
      }
      this.seconds += (performance.now() - begin) / 1000;
      this.see();
    }
    return this;
  }

  backTo(frame) {
    this.simulation.restore();
    this.frame = frame;
    this.frames.length = Math.min(this.frames.length, frame + 1);
    this.finite = this.frames.length === frame + 1;
  }

  see() {
    const bodies = this.request.world.bodies.map((_, i) => this.simulation.state(i));
    this.finite = numbers(bodies).every(Number.isFinite);
    if (this.finite) this.frames.push(bodies);
  }

  free() { this.simulation.free(); }
}

function sameBits(a, b) {
  const [these, those] = [a.flatMap(numbers), b.flatMap(numbers)];
  return a.length === b.length && these.every((x, i) => Object.is(x, those[i]));
}

function restored(make, request) {
  const run = new Run(make, request), half = Math.trunc(request.frames / 2);
  run.toFrame(half);
  if (!run.simulation.save?.()) return 'not offered';
  const first = [...run.toFrame(request.frames).frames];
  run.backTo(half);
  const second = run.toFrame(request.frames).frames;
  run.free();
  return sameBits(first, second) ? 'same bits' : 'other bits';
}

function reply(about, make, request) {
  const reply = { frames: [], seconds: [], same_bits: true, restored: '', cannot: '' };
  try {
    if (request.world.ropes.length > 0 && !about.ropes)
      throw new NotExpressible('no rope that turns its pulleys');
    for (let i = 0; i < request.runs; ++i) {
      const run = new Run(make, request).toFrame(request.frames);
      reply.seconds.push(run.seconds);
      reply.same_bits &&= i === 0 || sameBits(reply.frames, run.frames);
      if (i === 0) reply.frames = run.frames;
      run.free();
    }
    if (request.restored) reply.restored = restored(make, request);
  } catch (lacking) {
    if (!(lacking instanceof NotExpressible)) throw lacking;
    reply.cannot = lacking.message;
  }
  return reply;
}

const write = console.log;
console.log = console.error;  // an engine's output is no reply
const [name, aboutIt] = process.argv.slice(2);
if (!engines.includes(name))
  throw new Error(`runner.mjs: no engine "${name}"; there are ${engines.join(', ')}`);
const { about, make } = await import(`./${name}.mjs`);
const variants = settings[`${name}.mjs`];
if (aboutIt === '--about') {
  write(JSON.stringify({ plane: false, ...about, variants, behind: 'WebAssembly' }));
} else {
  const request = JSON.parse(readFileSync(0, 'utf8'));
  if (!variants.some((v) => v.name === request.variant))
    throw new Error(`runner.mjs: ${about.name} has no variant "${request.variant}"; it has ` +
      variants.map((v) => `"${v.name}"`).join(', '));
  write(JSON.stringify(reply(about, make, request)));
}
