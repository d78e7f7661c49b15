// The parts of the charts, tables, maps and the chooser that need no page. Run: node --test tests/site/
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { createContext, runInContext } from 'node:vm';

function loaded(...files) {
  const context = createContext({ window: {}, URLSearchParams, performance, console, atob });
  for (const file of files)
    runInContext(readFileSync(new URL('../../report/site/assets/' + file, import.meta.url), 'utf8'), context);
  return context.window.oddity;
}

const { charts, trials, map, choosing, isPublished } = loaded(
  'findings.js',
  'marks.js',
  'diagrams.js',
  'chart.js',
  'trials.js',
  'map.js',
  'typed.js',
  'asking.js',
  'searching.js',
  'advice.js',
  'chooser.js',
);
test('models with the errors of the book are known by their names', () => {
  for (const model of ['published equations', 'listing as printed', 'equation (7) as printed', 'fixed tip, as proposed'])
    assert.ok(isPublished(model), model);
  for (const model of ['one angle', 'Cartesian', 'equations of motion']) assert.ok(!isPublished(model), model);
});

const plain = (x) => JSON.parse(JSON.stringify(x));

const styles = {
  colours: { exact: 0, simple: 1 },
  marks: {},
  families: {
    'explicit Euler': 'explicit steps',
    'velocity Verlet': 'partitioned',
    'closed form': 'closed form',
    'Runge-Kutta 4': 'explicit steps',
  },
};
const method = (model, algorithm, resolution, trials, precision = 'double') => ({
  model,
  algorithm,
  resolution,
  precision,
  trials,
});
const swing = {
  name: 'swing',
  unit: 'rad',
  need: 1e-6,
  floor: 1e-16,
  size: 0.5,
  charts: ['evaluations'],
  methods: [
    method('simple', 'closed form', '', [[0, 0.2, 4, 100, 1, 'i']]),
    method('exact', 'explicit Euler', 'step', [
      [0.1, 50, 80, 1000, 1, 'X'],
      [0.05, 0.1, 160, 2000, 1, 'i'],
      [0.025, 0.01, 320, 4000, 1, 'i'],
    ]),
    method('exact', 'velocity Verlet', 'step', [
      [0.1, 0.009, 10, 200, 1, 'i'],
      [0.05, 5e-7, 20, 400, 1, 'o'],
      [0.025, null, 40, 800, 1, 'N'],
    ]),
    method('exact', 'Runge-Kutta 4', 'step', [
      [0.1, 1e-7, 40, 600, 1, 'o'],
      [0.05, 1e-9, 80, 1200, 1, 'o'],
    ]),
  ],
};
const methods = charts.methodsOf(swing, styles);

test('numbers are as short as a reader can use', () => {
  assert.equal(charts.number(0), '0');
  assert.equal(charts.number(0.0312, 3), '0.0312');
  assert.equal(charts.number(1e-10), '10⁻¹⁰');
  assert.equal(charts.number(4.88e-4, 3), '4.88×10⁻⁴');
  assert.equal(charts.number(null), 'no number');
  assert.equal(charts.count(1234567), '1,234,567');
  assert.equal(charts.duration(28.4), '28.4 ns');
  assert.equal(charts.duration(6600), '6.6 µs');
  assert.equal(charts.inUnit(0.5, 'm, m, rad'), '0.5');
  assert.equal(charts.needOfGame(0.01, 'm'), '1 cm');
  assert.equal(charts.needOfGame(Math.PI / 180, 'rad'), '1°');
});

test('the front has the points that no other point beats', () => {
  const front = charts.front(
    methods.flatMap((m) => m.points),
    'evaluations',
    swing.floor,
  );
  assert.deepEqual(
    front.map((p) => [p.evaluations, p.error]),
    [
      [4, 0.2],
      [10, 0.009],
      [20, 5e-7],
      [40, 1e-7],
      [80, 1e-9],
    ],
  );
});

test('points of equal cost and error are on the front together, and errors below the floor are equal', () => {
  const twins = charts.methodsOf(
    {
      methods: [
        method('exact', 'a', '', [[0, 1e-18, 3, 1, 0, 'o']]),
        method('exact', 'b', '', [[0, 1e-17, 3, 1, 0, 'o']]),
        method('exact', 'c', '', [[0, 1e-19, 4, 1, 0, 'o']]),
      ],
    },
    styles,
  );
  assert.deepEqual(
    charts
      .front(
        twins.flatMap((m) => m.points),
        'evaluations',
        1e-16,
      )
      .map((p) => p.method.algorithm),
    ['a', 'b'],
  );
});

test('the frame has whole decades, and points without a number are above it', () => {
  const at = charts.frame(swing, methods, 'evaluations');
  assert.deepEqual([at.x.low, at.x.high, at.y.low, at.y.high], [0, 3, -9, 2]);
  assert.equal(at.strip, true);
  assert.equal(charts.part(at.x, 10), 1 / 3);
  assert.deepEqual(plain(charts.ticks(at.x, 9)), [1, 10, 100, 1000]);
  assert.equal(charts.ticks({ low: -16, high: 0, log: true }, 4).length <= 5, true);
});

test('an error of zero is drawn at the floor, or a decade below the least', () => {
  const exact = {
    ...swing,
    methods: [
      method('exact', 'a', '', [
        [0, 0, 3, 1, 0, 'o'],
        [0, 1e-3, 3, 1, 0, 'o'],
      ]),
    ],
  };
  const at = charts.frame({ ...exact, need: 0 }, charts.methodsOf(exact, styles), 'evaluations');
  assert.equal(Math.round(Math.log10(at.ordinate({ error: 0 }))), -4);
});

test('at most eight curves are in colour, those of the title among them', () => {
  const many = {
    ...swing,
    methods: Array.from({ length: 30 }, (_, i) =>
      method('exact', 'algorithm ' + i, 'step', [
        [0.1, 10 ** -i, 10 * 2 ** i, 1, 0, 'o'],
        [0.05, 10 ** -i / 2, 20 * 2 ** i, 1, 0, 'o'],
      ]),
    ),
  };
  const all = charts.methodsOf(many, styles);
  const chosen = charts.highlighted(all, charts.frame(many, all, 'evaluations'), 1e-16, [all[29]]);
  assert.equal(chosen.size, 8);
  assert.equal(chosen.has(all[29]), true);
});

test('the finding compares with explicit Euler, at the accuracy of a game, in counted evaluations', () => {
  const found = charts.finding(swing, methods, 'evaluations', { error: Math.PI / 180, says: '1°' });
  assert.equal(
    found.says,
    'Within 1°, velocity Verlet needs 10 evaluations, 32 times fewer than explicit Euler.',
  );
  assert.deepEqual(plain(found.of.map((m) => m.algorithm)), ['velocity Verlet', 'explicit Euler']);
});

test('the finding reports where explicit Euler does not reach the accuracy', () => {
  const found = charts.finding(swing, methods, 'evaluations', { error: 1e-6, says: '10⁻⁶' });
  assert.match(found.says, /velocity Verlet needs 20 evaluations; explicit Euler does not come there\.$/);
});

test('the finding of a quantity without motion names the least work for the tolerance, and its measure', () => {
  assert.equal(
    charts.finding(swing, methods, 'evaluations', null).says,
    'velocity Verlet (exact) reaches 10⁻⁶ rad with the least counted work: 20 evaluations; Runge-Kutta 4 (exact) needs 2 times as much.',
  );
  assert.match(charts.finding(swing, methods, 'time', null).says, / in the least time measured: 400 ns;/);
});

test('the finding of rows counts the methods that are right', () => {
  const rows = { ...swing, charts: [] };
  assert.equal(
    charts.finding(rows, methods, null, null).says,
    'Only Runge-Kutta 4 (exact) of 4 methods is as exact as needed.',
  );
});

test('a point is described with everything known about it', () => {
  const lines = charts.description(methods[1].points[0], swing, {
    outcomes: { X: 'diverged' },
    timeUnit: 's',
  });
  assert.deepEqual(plain(lines), [
    'explicit Euler (exact)',
    'step 0.1 s',
    'error 50 rad',
    '80 evaluations',
    '1 µs ± 1 ns',
    'diverged',
  ]);
});

test('labels do not lie on each other', () => {
  const curve = (y) => ({ width: 80, spots: [{ x: 100, y }], way: [{ x: 100, y }] });
  const placed = charts.placeLabels([curve(50), curve(52), curve(54), curve(56)], {
    left: 0,
    right: 400,
    top: 0,
    bottom: 200,
  });
  for (const a of placed)
    for (const b of placed)
      if (a !== b)
        assert.equal(
          Math.min(a.right, b.right) - Math.max(a.left, b.left) > 0.5 &&
            Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 0.5,
          false,
        );
});

test('a table sorts by a column, and rows without a number stay last', () => {
  const points = [{ e: 3 }, { e: null }, { e: 1 }];
  assert.deepEqual(plain(trials.sorted(points, (p) => p.e, false).map((p) => p.e)), [1, 3, null]);
  assert.deepEqual(plain(trials.sorted(points, (p) => p.e, true).map((p) => p.e)), [3, 1, null]);
});

test("theory's border is between the steps that it separates", () => {
  const steps = [1, 0.5, 0.25, 0.125];
  assert.equal(map.border(null, steps), 0);
  assert.equal(map.border(0, steps), 4);
  assert.equal(map.border(0.5, steps), 1.5);
  assert.equal(map.border(Math.SQRT1_2, steps), 1);
  assert.equal(
    map.borderPath(
      [
        [1, 0.5, 'oooo'],
        [2, 0, 'XXXX'],
      ],
      steps,
    ),
    'M0,1.500H1V4.000H2',
  );
});

test("the map's finding takes the method that is ok everywhere up to the longest step", () => {
  const stability = {
    steps: [1, 0.5, 0.25],
    parameter: 'a',
    map: [
      {
        model: 'exact',
        algorithm: 'explicit Euler',
        rows: [
          [1, 0, 'XXo'],
          [2, 0, 'XXi'],
        ],
      },
      {
        model: 'exact',
        algorithm: 'Runge-Kutta 4',
        rows: [
          [1, 1, 'Xoo'],
          [2, 1, 'ooo'],
        ],
      },
    ],
  };
  assert.equal(
    map.finding(stability, 's'),
    'Runge-Kutta 4 (exact) ends ok at every a up to the longest step, 0.5 s.',
  );
});

const pendulum = {
  number: '3.5',
  title: 'Pendulum',
  horizon: 10,
  time_unit: 's',
  close: { rad: Math.PI / 180 },
  observables: ['theta'],
  norms: [{ unit: 'rad', components: [0] }],
  exact: ['one angle'],
  faulted: [],
  styles,
  parameters: [{ name: 'a', value: 0.5, unit: 'rad', says: 'angle', least: 0.001, most: 3.14, whole: false }],
};
const rough = {
  ...pendulum,
  number: '3.31',
  close: { m: 0.01, rad: Math.PI / 180 },
  observables: ['x', 'y', 'theta'],
  norms: [
    { unit: 'm', components: [0, 1] },
    { unit: 'rad', components: [2] },
  ],
  parameters: [],
};

test('an error may have a unit', () => {
  assert.deepEqual(plain(choosing.asked('1 cm', 'm')), { value: 0.01, text: '1cm' });
  assert.deepEqual(plain(choosing.asked('2°', 'rad')), { value: (2 * Math.PI) / 180, text: '2deg' });
  assert.equal(choosing.asked('1 cm', 'rad'), null);
  assert.equal(choosing.asked('-1', 'm'), null);
  assert.equal(choosing.asked('', 'm'), null);
  assert.equal(choosing.asked('1; rm -rf', 'm'), null);
});

test('a link contains the question and comes back as the same link', () => {
  const state = choosing.fromHash('#scene=3.31&error=2cm,3deg&fps=30&budget=5us&precision=any', [
    pendulum,
    rough,
  ]);
  assert.equal(
    choosing.command(state),
    './oddity choose 3.31 --error 2cm,3deg --horizon 10 --fps 30 --budget 5us --precision any',
  );
  assert.deepEqual(plain(choosing.fromHash(choosing.toHash(state), [pendulum, rough])), plain(state));
});

test('a link and a field take the units that the program takes', () => {
  const units = { rad: { rad: 1, deg: Math.PI / 180 }, s: { s: 1, ms: 0.001, min: 60 }, '1/s': { '1/s': 1, Hz: 1 } };
  const scene = { ...pendulum, units };
  const state = choosing.fromHash('#scene=3.5&a=60deg&horizon=1%20min&fps=120Hz', [scene]);
  assert.equal(state.parameters.a, (60 * Math.PI) / 180);
  assert.equal(state.horizon, 60);
  assert.equal(state.fps, 120);
  assert.throws(() => choosing.setParameter(state, scene.parameters[0], '2 cm'), /a: .2 cm. has a unit that does not fit: rad, deg do/);
  assert.throws(() => choosing.setParameter(state, scene.parameters[0], '0x1'), /a: /);
  assert.throws(() => choosing.setPositive(state, 'fps', '2 cm', 'the frame rate'), /the frame rate: .*Hz do/);
});

test('one error without a unit is for all units, and each has its own in the command', () => {
  const state = choosing.fromHash('#scene=3.31&error=0.02', [pendulum, rough]);
  assert.match(choosing.command(state), /--error 0\.02m,0\.02rad /);
  assert.deepEqual(plain(choosing.fromHash('#scene=3.31&error=3deg,2cm', [pendulum, rough]).errors.m), { value: 0.02, text: '2cm' });
});

test('a bad link gets a message about its fault', () => {
  for (const [hash, message] of [
    ['#scene=9.9', /no scene "9.9"/],
    ['#scene=3.5&b=1', /no parameter "b"/],
    ['#scene=3.5&a=4', /out of its range/],
    ['#scene=3.5&error=1cm', /error in rad/],
    ['#scene=3.5&fps=0', /above zero/],
    ['#scene=3.5&precision=half', /double, float or any/],
    ['#scene=3.5&a=1&a=2', /"a" is given twice/],
    ['#scene=3.5&error=1deg&error=2deg', /"error" is given twice/],
    ['#scene=3.5&horizon=0x10', /the horizon: “0x10” has a unit that does not fit/],
    ['#scene=3.5&a=0x1', /a: “0x1” has a unit that does not fit/],
    ['#scene=3.5&budget=5', /a time with its unit/],
    ['#scene=3.5&budget=1e-20s', /a time with its unit/],
    ['#scene=3.5&error=1,5deg', /error in rad/],
    ['#scene=3.5&error=1e13', /error in rad/],
    ['#scene=3.5&error=1deg,', /error in rad/],
    ['#scene=3.31&error=1cm,5deg,7', /error in m or rad/],
    ['#scene=3.31&error=1,1cm,1deg', /error in m or rad/],
    ['#scene=3.31&error=1cm', /missing in rad/],
    ['#scene=3.31&error=1cm,1deg,2cm', /two errors in m/],
    ['#scene=3.5&horizon=1e-3', /shorter than a frame/],
    ['#scene=3.5&horizon=1e6', /of at most a million/],
    ['#scene=%3Cscript%3E', /no scene "<script>"/],
  ])
    assert.throws(() => choosing.fromHash(hash, [pendulum, rough]), message);
});

test('errors are distances in each unit, and not a number where a motion broke off', () => {
  const truth = [0, 0, 0, 3, 4, 1],
    observed = [9, 9, 9, 0, 0, 1.5];
  assert.deepEqual(plain(choosing.errorsOf(observed, truth, rough)), { m: 5, rad: 0.5 });
  assert.equal(choosing.errorsOf([0, 0, 0, NaN, 0, 1], truth, rough).m, NaN);
  const state = choosing.usual(rough);
  assert.equal(choosing.inNeeds({ m: 0.005, rad: 0 }, state), 0.5);
  assert.equal(choosing.inNeeds({ m: NaN, rad: 0 }, state), Infinity);
});

test('a simple method with a margin is preferred to the cheapest, and of near ties the most accurate', () => {
  const row = (algorithm, resolution, seconds, error) => ({
    model: 'exact',
    algorithm,
    resolution,
    seconds,
    error,
    holds: error <= 1,
  });
  const rows = [
    row('Adams-Bashforth 4', 'step', 1e-9, 0.1),
    row('velocity Verlet', 'step', 2e-9, 0.3),
    row('Runge-Kutta 4', 'step', 2.4e-9, 0.01),
    row('explicit Euler', 'step', 1.5e-9, 0.9),
    row('Fehlberg 7(8)', 'tolerance', 1e-9, 1e-6),
  ];
  assert.equal(choosing.pick(rows, null).row.algorithm, 'Runge-Kutta 4');
  assert.equal(choosing.pick(rows, 2.2e-9).row.algorithm, 'velocity Verlet');
  assert.equal(choosing.pick(rows, 1.2e-9).row.algorithm, 'Fehlberg 7(8)');
  assert.equal(choosing.pick(rows, 1e-10), null);
  const faulted = { ...row('closed form', '', 1e-10, 1e-6), faulted: true };
  assert.equal(choosing.pick([faulted, ...rows], null).row.algorithm, 'Runge-Kutta 4');
  assert.equal(choosing.pick([faulted], null), null);
});

// A pendulum's small angle as an engine, exact and by two steppers.
const engine = {
  algorithms: [
    { name: 'closed form', kind: 'closed form', order: 0, resolution: '', inFloat: true },
    { name: 'explicit Euler', kind: 'fixed', order: 1, resolution: 'step', inFloat: true },
    { name: 'velocity Verlet', kind: 'partitioned', order: 2, resolution: 'step', inFloat: true },
  ],
  scene: () => ({
    parameters: ['a'],
    models: [{ name: 'one angle', algorithms: ['closed form', 'explicit Euler', 'velocity Verlet'] }],
  }),
  run({ parameters: { a }, algorithm, setting, times }) {
    if (algorithm === 'closed form')
      return {
        observed: Float64Array.from(times, (t) => a * Math.cos(t)),
        evaluations: times.length - 1,
        ending: 'reached',
        seconds: 1e-6,
      };
    let q = a,
      v = 0,
      evaluations = 0;
    const observed = Float64Array.from(times, (t, i) => {
      if (!i) return q;
      const steps = Math.round((t - times[i - 1]) / setting),
        h = (t - times[i - 1]) / steps;
      for (let k = 0; k < steps; ++k, ++evaluations) {
        if (algorithm === 'explicit Euler') [q, v] = [q + h * v, v - h * q];
        else {
          v -= (h / 2) * q;
          q += h * v;
          v -= (h / 2) * q;
        }
      }
      return q;
    });
    return { observed, evaluations, ending: 'reached', seconds: 1e-5 };
  },
};

test('the search judges by the finest run and finds methods that hold', () => {
  const state = choosing.usual(pendulum),
    found = { rows: [], tried: 0, all: 0, truth: null };
  for (const step of choosing.search(state, engine, found)) assert.equal(step, undefined);
  assert.equal(found.truth.algorithm, 'closed form');
  assert.equal(found.truth.beside.algorithm, 'velocity Verlet');
  assert.equal(found.truth.errors.rad < 1e-5, true);
  assert.equal(found.tried, 3);
  const verlet = found.rows.find((r) => r.algorithm === 'velocity Verlet');
  assert.equal(verlet.holds, true);
  assert.equal(Math.round(1 / (verlet.setting * state.fps)), 1);
  for (const row of found.rows) row.seconds = row.evaluationsPerFrame * 1e-9 + (row === verlet ? 1e-9 : 0);
  assert.match(
    choosing.answer(state, found)[0],
    /^Take one angle by closed form: 1 evaluation and 1 ns a frame/,
  );
  const euler = found.rows.filter((r) => r.algorithm === 'explicit Euler');
  assert.equal(euler[0].holds, false);
  assert.equal(euler[euler.length - 1].error <= 1 / 3, true);
});
