// Computations of the player without a page: node --test tests/site

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import test from 'node:test';

globalThis.window = globalThis;
const require = createRequire(import.meta.url);
for (const name of ['typed', 'scale', 'frames', 'permalink', 'portrait', 'picture']) require(`../../report/site/assets/${name}.js`);
const { oddity } = globalThis;

const near = (a, b, allowed) => assert.ok(Math.abs(a - b) <= allowed, `${a} is not ${b} within ${allowed}`);

test('a slider goes from end to end, and back to the value that it shows', () => {
  const parameters = [
    { value: 0.5235987755982988, unit: 'rad', least: 0.001, most: 3.14 },
    { value: 1, unit: 'm', least: 0.001, most: 1000 },
    { value: 0, unit: 'm/s', least: -1000, most: 1000 },
    { value: 0.4, unit: 'N s/m', least: 0, most: 1000 },
    { value: 2, unit: 'm', least: null, most: null },
  ];
  for (const parameter of parameters) {
    const scale = oddity.scaleOf(parameter);
    assert.equal(scale.value(0), scale.least);
    assert.equal(scale.value(1), scale.most);
    for (let place = 0; place <= 1; place += 1 / 64) near(scale.place(scale.value(place)), place, 1e-3);
    near(scale.place(parameter.value), scale.place(scale.value(scale.place(parameter.value))), 1e-3);
  }
});

test('a range over decades is laid out by decades, one through zero on both sides of it', () => {
  const length = oddity.scaleOf({ value: 1, unit: 'm', least: 0.001, most: 1000 });
  near(length.place(1), 0.5, 1e-12);
  near(length.place(10), 2 / 3, 1e-12);
  const speed = oddity.scaleOf({ value: 1, unit: 'm/s', least: -1000, most: 1000 });
  near(speed.place(0), 0.5, 1e-12);
  assert.ok(speed.place(2) - speed.place(1) > 0.02);
  const angle = oddity.scaleOf({ value: 0.5, unit: 'rad', least: 0.001, most: 3.001 });
  near(angle.place(1.501), 0.5, 1e-12);
});

test('a slider gives round numbers, whole ones where they have to be', () => {
  const gravity = oddity.scaleOf({ value: 9.81, unit: 'm/s^2', least: 0.001, most: 1000 });
  assert.ok(String(gravity.value(0.6543)).length <= 5);
  const count = oddity.scaleOf({ value: 5, unit: '', least: 1, most: 9, whole: true });
  assert.ok(Number.isInteger(count.value(0.33)));
});

test('numbers are read as people write them', () => {
  assert.equal(oddity.typed(' 0,5 '), 0.5);
  assert.equal(oddity.typed('\u22121e-3'), -0.001);
  assert.equal(oddity.typed('1/60'), 1 / 60);
  for (const x of [1 / 60, 1 / 4096, 0.25, 7, 1e-9]) near(oddity.typed(oddity.inField(x)), x, 1e-15);
  assert.equal(oddity.inField(1 / 60), '1/60');
  assert.equal(oddity.inField(Math.PI / 6), '0.523599');
  for (const bad of ['', 'x', '1/0', '1/2/3', '/2', '1..2', '0x10', 'Infinity', '1 2', '<b>']) assert.equal(oddity.typed(bad), null);
});

test('a number may have a unit that fits, in any of its spellings', () => {
  const angles = { rad: 1, mrad: 0.001, deg: Math.PI / 180 };
  for (const text of ['60deg', '60 deg', '60\u00b0', '60,0 \u00b0']) near(oddity.number(text, 'rad', angles), Math.PI / 3, 1e-15);
  assert.equal(oddity.number('2 rad', 'rad', angles), 2);
  assert.equal(oddity.number('-1/4 mrad', 'rad', angles), -0.00025);
  const pulls = { 'm/s^2': 1, 'cm/s^2': 0.01 };
  for (const text of ['981 cm/s^2', '981cm/s2', '981 cm/s\u00b2']) near(oddity.number(text, 'm/s\u00b2', pulls), 9.81, 1e-12);
  assert.equal(oddity.number('9.81 m/s2', 'm/s\u00b2', pulls), 9.81);
  const rates = { '1/s': 1, Hz: 1 };
  for (const text of ['60 1/s', '60/s', '60Hz']) assert.equal(oddity.number(text, '1/s', rates), 60);
  assert.equal(oddity.number('5 us', 's', { us: 1e-6 }), oddity.number('5 \u00b5s', 's', { us: 1e-6 }));
});

test('a unit that does not fit is refused, with those that do', () => {
  assert.throws(() => oddity.number('2 cm', 'rad', { rad: 1, deg: 1 }), /2 cm. has a unit that does not fit: rad, deg do/);
  assert.throws(() => oddity.number('2 cm', '1'), /this number has none/);
  assert.throws(() => oddity.number('60deg'), /this number has none/);
  for (const bad of ['deg', '60 deg deg', '60degx', '1e400', '', '6 0deg', 'constructor', '1 __proto__'])
    assert.throws(() => oddity.number(bad, 'rad', { deg: 1 }), Error, bad);
});

test('numbers are written with the digits asked', () => {
  assert.equal(oddity.written(0.017453), '0.0175');
  assert.equal(oddity.written(1.2345e-7), '1.23e\u22127');
  assert.equal(oddity.written(12345), '12345');
  assert.equal(oddity.written(-2), '\u22122');
  assert.equal(oddity.written(Infinity), '\u221e');
  assert.equal(oddity.letter('theta0_dot'), '\u03b8\u0307\u2080');
  assert.equal(oddity.letter('stiff'), 'stiff');
  assert.equal(oddity.written(NaN), '\u2013');
  assert.equal(oddity.nameOfNeed('rad', Math.PI / 180), '1\u00b0');
  assert.equal(oddity.nameOfNeed('m', 0.01), '1 cm');
});

test('floats come out of base64', () => {
  const bytes = Buffer.from(new Float32Array([1.5, -2, NaN]).buffer);
  assert.deepEqual([...oddity.floats(bytes.toString('base64'))], [1.5, -2, NaN]);
  const wholes = Buffer.from(new Uint16Array([0, 1, 65535]).buffer);
  assert.deepEqual([...oddity.wholes(wholes.toString('base64'))], [0, 1, 65535]);
  const changes = Buffer.from([5, 0, 0xff, 0, 0, 1, 0xff, 0]);  // +5, +256; -1, +0
  assert.deepEqual([...oddity.fromChanges(changes.toString('base64'), 2)], [5, 256, 4, 256]);
});

test('steps divide the intervals of a trial evenly and are seen at least once a frame', () => {
  const even = oddity.stepTimes(10, 4, 1 / 60, 1 / 60);
  assert.equal(even.times.length, 601);
  near(even.step, 1 / 60, 1e-15);
  const fine = oddity.stepTimes(10, 4, 1 / 60, 1 / 128);
  near(fine.step, 1 / 128, 1e-15);
  for (let i = 1; i < fine.times.length; i += 1) {
    const between = (fine.times[i] - fine.times[i - 1]) / fine.step;
    near(between, Math.round(between), 1e-9);
    assert.ok(fine.times[i] - fine.times[i - 1] <= 1 / 60 + 1e-12);
  }
  const coarse = oddity.stepTimes(10, 4, 1 / 60, 100);
  assert.deepEqual([...coarse.times], [0, 2.5, 5, 7.5, 10]);
});

const sine = (times) => ({ times, count: 1, observed: Float64Array.from(times, Math.sin) });

test('the reference between its frames is known far better than a game needs', () => {
  const motion = sine(oddity.frameTimes(10, 600));
  for (const t of [0.001, 0.02, 1.2345, 5, 9.999]) near(oddity.throughSix(motion, t)[0], Math.sin(t), 1e-12);
  motion.observed[0] = NaN;
  near(oddity.throughSix(motion, 0.02)[0], Math.sin(0.02), 1e-11);
});

test('a motion is drawn straight between its frames, and stays where it breaks off', () => {
  const motion = { times: Float64Array.of(0, 1, 2, 3), count: 2,
    observed: Float64Array.of(0, 0, 1, 10, NaN, NaN, NaN, NaN) };
  assert.deepEqual([...oddity.between(motion, 0.5)], [0.5, 5]);
  assert.deepEqual([...oddity.between(motion, 1.5)], [1, 10]);
  assert.deepEqual([...oddity.between(motion, 3)], [1, 10]);
});

test('an error is the distance of points, each unit by itself', () => {
  const norms = [{ unit: 'm', components: [0, 1] }, { unit: 'rad', components: [2] }];
  assert.deepEqual(oddity.distances([3, 4, 1], [0, 0, 0.5], norms, ['m', 'rad']), [5, 0.5]);
  const two = [{ unit: 'm', components: [0] }, { unit: 'm', components: [1] }];
  assert.deepEqual(oddity.distances([3, 4], [0, 0], two, ['m']), [4]);
  assert.ok(Number.isNaN(oddity.distances([NaN, 4], [0, 0], two, ['m'])[0]));
});

test('a motion is judged at all its times', () => {
  const times = oddity.frameTimes(1, 10);
  const truth = { times, count: 1, observed: Float64Array.from(times, () => 0) };
  const motion = { times, count: 1, observed: Float64Array.from(times, (t) => (t > 0.75 ? NaN : t / 10)) };
  const judged = oddity.judged(motion, truth, [{ unit: 'm', components: [0] }], { m: 0.045 });
  near(judged.worst[0], 0.07, 1e-15);
  near(judged.since, 0.5, 1e-15);
  near(judged.broken, 0.8, 1e-15);
  truth.observed[0] = NaN;
  const itself = oddity.judged(truth, truth, [{ unit: 'm', components: [0] }], { m: 1 });
  assert.deepEqual([itself.since, itself.broken, itself.count], [null, null, 10]);
  truth.observed.fill(NaN);
  const unjudged = oddity.judged({ ...motion, observed: times }, truth, [{ unit: 'm', components: [0] }], { m: 1 });
  assert.deepEqual([unjudged.since, unjudged.broken, unjudged.count], [null, null, 0]);
});

const known = {
  parameters: [{ name: 'a', least: 0.001, most: 3.14 }, { name: 'n', least: 1, most: 9, whole: true }],
  methods: [
    { model: 'one angle', algorithm: 'explicit Euler', precisions: ['double', 'float'], resolution: 'step' },
    { model: '(r, u, phi) & 100 %', algorithm: 'closed form', precisions: ['double'], resolution: '' },
  ],
  horizon: 10,
  speeds: [0.25, 1, 4],
  space: true,
  missing: 'this scene does not have',
};

test('frames as they come are each divided into as many steps as a usual one', () => {
  const [even, jitter, drop] = oddity.framesAs;
  const lengths = ({ times }) => [...times].slice(1).map((t, i) => t - times[i]);
  assert.deepEqual(oddity.timesOfSteps(10, 600, 1 / 60, 1 / 60), oddity.timesOfSteps(10, 600, 1 / 60, 1 / 60, even));
  const uneven = oddity.timesOfSteps(10, 600, 1 / 60, 1 / 60, jitter);
  assert.deepEqual(uneven, oddity.timesOfSteps(10, 600, 1 / 60, 1 / 60, jitter));
  assert.equal(uneven.times[uneven.times.length - 1], 10);
  const all = lengths(uneven).slice(0, -1);
  assert.ok(Math.min(...all) > 0.79 / 60 && Math.max(...all) < 1.21 / 60 && Math.max(...all) > 1.15 / 60);
  assert.ok(Math.max(...lengths(uneven)) <= uneven.step);
  const dropped = lengths(oddity.timesOfSteps(10, 600, 1 / 60, 1 / 120, drop));
  const twice = dropped.filter((x) => Math.abs(x - 1 / 60) < 1e-9).length;
  assert.ok(twice > 30 && twice < 90, `${twice} steps of twice the length`);
  assert.ok(dropped.every((x) => x > 0.99 / 120));
});

test('a permalink contains everything, and comes back the same', () => {
  const state = {
    parameters: { a: 0.6, n: 3 },
    rows: [
      { model: 'one angle', algorithm: 'explicit Euler', precision: 'float', setting: 1 / 60 },
      { model: '(r, u, phi) & 100 %', algorithm: 'closed form', precision: 'double', setting: 0 },
    ],
    time: 2.5,
    speed: 0.25,
    view: { azimuth: -171.5, elevation: 22.5 },
  };
  const uneven = { ...state, as: oddity.framesAs[2] };
  assert.deepEqual(oddity.permalink.parse(oddity.permalink.format(uneven), known), { state: uneven });
  for (const view of [state.view, { azimuth: 1e30, elevation: -1e-9 }])  // 1e+30, of which a link reads + as a space
    assert.deepEqual(oddity.permalink.parse(oddity.permalink.format({ ...state, view }), known), { state: { ...state, view } });
});

test('a bad permalink gives a sentence, and other anchors give nothing', () => {
  const bad = [
    '#play&p.a=x', '#play&p.a=4', '#play&p.n=2.5', '#play&p.zeta=1', '#play&row=one angle', '#play&%zz=1',
    '#play&row=%zz/a/double/1', '#play&row=one angle/explicit Euler/half/1', '#play&speed=3', '#play&at=soon',
    '#play&row=one angle/explicit Euler/double/0', '#play&row=one angle/explicit Euler/double/-1',
    '#play&row=<script>alert(1)</script>/explicit Euler/double/1', '#play&constructor=1', '#play&p.__proto__=1',
    '#play&row=one angle/explicit Euler/double/1/2', '#play&p.a=1&p.a=2', '#play&at=1&at=2', '#play&speed=1&speed=1', '#play&view=1,2&view=1,2',
    '#play&view=1', '#play&frames=odd', '#play&frames', '#play&view=1,x', '#play&view=1,91', '#play&view=1,2,3', '#play' + '&row=one angle/explicit Euler/double/1'.repeat(5),
  ];
  for (const hash of bad) {
    const read = oddity.permalink.parse(hash, known);
    assert.ok(read.problem && /^The link .*\.$/s.test(read.problem), hash);
  }
  assert.match(oddity.permalink.parse('#play&view=1,2', { ...known, space: false }).problem, /^The link turns /);
  for (const hash of ['', '#', '#claims', '#player', '#play'])
    assert.equal(oddity.permalink.parse(hash, known), null);
  assert.deepEqual(oddity.permalink.parse('#play&at=0', known),
    { state: { parameters: {}, rows: [], time: 0, speed: 1 } });
});

test('a phase portrait has places, and their rates by differences', () => {
  const phases = oddity.phases((motion, t) => [0, Math.cos(t)], null, 10, 1);
  for (const { t, place, rate } of phases.slice(1, -1)) {
    near(place, Math.cos(t), 0);
    near(rate, -Math.sin(t), 1e-4);
  }
});

test('the view widens for points that leave it, up to a distance, and comes back', () => {
  const asked = [], stage = { fit() {}, widen: (drawings) => asked.push(drawings.length), paint() {} };
  const before = oddity.stage;
  oddity.stage = () => stage;
  const motion = { times: [0, 1, 2, 3], values: null };
  const place = { 0: 0, 1: 5, 2: 1e6, 3: 0.5 };
  const motions = { space: false, defaults: {}, scene: { horizon: 3 }, seeTruth: (m, t) => [t / 3],
    drawing: (parameters, t, [x]) => ({ primitives: [{ points: [[x, 0, 0]], trail: false }] }) };
  const between = oddity.between;
  oddity.between = (m, t) => [place[Math.round(t)]];
  try {
    const picture = oddity.picture(null, motions);
    picture.show({}, motion, 'grey', [{ motion, colour: 'red' }]);
    for (const t of [0, 1, 2, 3]) picture.paint(t);
    assert.deepEqual(asked, [0, 1, 0, 0]);
  } finally {
    oddity.stage = before;
    oddity.between = between;
  }
});
