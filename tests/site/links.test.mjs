// Any link to a player or to the chooser gives a state, a problem in words, or no link. FUZZ_LINKS is the
// number of trials, ODDITY_SEED their seed. Some links are long: reading must not take the square of their
// length.

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import test from 'node:test';

globalThis.window = globalThis;
const require = createRequire(import.meta.url);
globalThis.window.oddity = { charts: { number: (x) => String(x) } };
for (const name of ['typed', 'scale', 'frames', 'permalink', 'asking']) require(`../../report/site/assets/${name}.js`);
const { oddity } = globalThis;

const parameter = { name: 'a', value: 0.5, least: 0.001, most: 3.14, unit: 'rad' };
const count = { name: 'n', value: 3, least: 1, most: 9, whole: true, unit: '' };
const known = {
  parameters: [parameter, count],
  methods: [{ model: 'one angle', algorithm: 'explicit Euler', precisions: ['double', 'float'], resolution: 'step' }],
  horizon: 10, speeds: [0.25, 1], space: true, missing: 'is not there',
};
const scenes = [{ number: '3.5', parameters: [parameter, count], close: { rad: 0.017 } }];

const players = ['#play&p.a=0.6&row=one%20angle/explicit%20Euler/double/0.0167&at=1.5&speed=0.25&view=30,22.5', '#play&p.n=4&at=0'];
const choosers = ['#scene=3.5&a=0.6&error=1deg&horizon=2&fps=120&budget=5us&precision=float', '#a=0.7&error=.5e-3'];
const pieces = ['&', '=', '/', ',', '%', '%2', '%ff', '%F0%9F%92%A9', '+', '#', '1', '9'.repeat(40), '9'.repeat(100000), '1/0', '-', 'e9', 'e999', '.', ' ',
  'NaN', 'Infinity', '__proto__', 'constructor', 'p.__proto__=1', 'row=', 'view=', '\u0000', '\ud800', '°', 'µs', '<b>', ' x y'];

// SplitMix64, like the program's own.
function random(seed) {
  let state = BigInt(seed);
  const mask = (1n << 64n) - 1n;
  return (below) => {
    state = (state + 0x9e3779b97f4a7c15n) & mask;
    let z = state;
    z = ((z ^ (z >> 30n)) * 0xbf58476d1ce4e5b9n) & mask;
    z = ((z ^ (z >> 27n)) * 0x94d049bb133111ebn) & mask;
    return Number((z ^ (z >> 31n)) % BigInt(below));
  };
}

/** A text with a few pieces inserted, cut out or repeated. */
function mutated(text, below) {
  for (let left = 1 + below(4); left > 0; --left) {
    const at = below(text.length + 1), to = at + below(8);
    const kind = below(4);
    if (kind === 0) text = text.slice(0, at) + text.slice(to);
    else if (kind === 1) text = text.slice(0, to) + text.slice(at);
    else if (kind === 2) text = text.slice(0, at) + String.fromCharCode(below(256)) + text.slice(at);
    else text = text.slice(0, at) + pieces[below(pieces.length)] + text.slice(at);
  }
  return text;
}

function readPlayer(hash) {
  const read = oddity.permalink.parse(hash, known);
  if (read === null) return;
  if (read.problem) return assert.equal(typeof read.problem, 'string');
  const again = oddity.permalink.parse(oddity.permalink.format(read.state), known);
  if (again !== null) assert.equal(again.problem, undefined, `${hash} is written so that it cannot be read: ${again.problem}`);
}

function readChooser(hash) {
  let state;
  try {
    state = oddity.choosing.fromHash(hash, scenes);
  } catch (error) {
    assert.equal(error.constructor, Error, `${hash}: ${error}`);
    return;
  }
  const written = oddity.choosing.toHash(state);
  assert.equal(oddity.choosing.toHash(oddity.choosing.fromHash(written, scenes)), written, hash);
  assert.match(oddity.choosing.command(state), /^\.\/oddity choose 3\.5 [ -~]*$/, `${hash} is not a command`);
}

for (const [target, seeds, read] of [['a player', players, readPlayer], ['the chooser', choosers, readChooser]])
  test(`any link to ${target} is a state or a problem`, () => {
    const below = random(process.env.ODDITY_SEED ?? 1);
    const count = Number(process.env.FUZZ_LINKS ?? 20000);
    assert.ok(count >= 1, 'FUZZ_LINKS is a count');
    for (let left = count; left > 0; --left) {
      const hash = mutated(seeds[below(seeds.length)], below);
      read(hash);
    }
  });
