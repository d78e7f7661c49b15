// Shared code of the adapters in JavaScript: simulation.hpp and the vectors of runner.cpp in this language.

import { readFileSync } from 'node:fs';

export const ground = -1;

const json = (file) => JSON.parse(readFileSync(new URL(file, import.meta.url), 'utf8'));
/// The variants of each engine, by its adapter's file.
export const settings = json('variants.json');
export const installedVersion = (npmModule) => json(`node_modules/${npmModule}/package.json`).version;

/// The engine lacks a feature that the world needs: "no joint that keeps a distance".
export class NotExpressible extends Error {}

export const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (s, a) => [s * a[0], s * a[1], s * a[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const unit = (a) => times(1 / Math.hypot(...a), a);
export const isZero = (a) => a.every((x) => x === 0);

/// A unit vector across this one: z for a vector in the plane.
export const beside = (a) => unit(cross(cross(a, Math.abs(unit(a)[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]), a));

/// The vector rotated by the unit quaternion.
export function turned([w, x, y, z], a) {
  const u = [x, y, z], twice = times(2, cross(u, a));
  return plus(plus(a, times(w, twice)), cross(u, twice));
}
export const back = ([w, x, y, z]) => [w, -x, -y, -z];
/// The rotation b followed by a.
export function after([aw, ax, ay, az], [bw, bx, by, bz]) {
  return [aw * bw - ax * bx - ay * by - az * bz, aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx, aw * bz + ax * by - ay * bx + az * bw];
}

export const atRest = {
  position: [0, 0, 0], orientation: [1, 0, 0, 0], velocity: [0, 0, 0], spin: [0, 0, 0],
};

/// Initial state of a body; the ground is at the origin.
export const start = (world, body) => body === ground ? atRest : world.bodies[body].start;

/// A point and a direction of the world in the axes of a body.
export const pointIn = ({ position, orientation }, at) => turned(back(orientation), minus(at, position));
export const directionIn = ({ orientation }, axis) => turned(back(orientation), axis);

/// Rotations in the plane, about z.
export const angle = ([w, , , z]) => 2 * Math.atan2(z, w);
export const aboutZ = (angle) => [Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)];

const flat = ([, , z]) => z === 0;
const upright = ([x, y]) => x === 0 && y === 0;

/// For engines of the plane. There a ball joint is a hinge, and on a cylinder joint nothing turns, as its
/// axis is in the plane.
export function expectInPlane({ gravity, shaking, turning, floor, bodies, joints, springs }) {
  const inPlane = [gravity, shaking, floor].every(flat) && upright(turning) &&
    bodies.every(({ start: { position, velocity, spin, orientation } }) =>
      flat(position) && flat(velocity) && upright(spin) && upright(orientation.slice(1))) &&
    joints.every(({ kind, at, axis, end }) => flat(at) && (kind !== 'hinge' || upright(axis)) &&
      (kind !== 'cylinder' || flat(axis)) && (kind !== 'rod' || flat(end))) &&
    springs.every(({ at, end }) => flat(at) && flat(end));
  if (!inPlane) throw new NotExpressible('the plane of x and y alone');
}
