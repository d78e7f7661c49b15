// A world in MuJoCo's own language [manual: mujoco.readthedocs.io, XML reference].

import {
  NotExpressible, after, back, beside, cross, directionIn, ground, isZero, minus, pointIn, start, unit,
} from './simulation.mjs';

const numbers = (list) => list.join(' ');

/// The joint by which each body hangs on another or on the ground; bodies without one are free.
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

/// Initial coordinate of a slide. For MuJoCo a tendon length of -1 means none; these lengths are far from
/// that.
const slideAtStart = (body) => 100 * (1 + body);

/// A rod has no mass: it is two hinges across it at one end and a ball joint at the other. The wheel that a
/// slide turns is the slide's armature.
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

export function xml(world, options) {
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
