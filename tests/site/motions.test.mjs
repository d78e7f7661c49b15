// The first motions of a player, without a page: node --test tests/site

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import test from 'node:test';

globalThis.window = globalThis;
const require = createRequire(import.meta.url);
for (const name of ['typed', 'scale', 'frames', 'findings', 'motions']) require(`../../report/site/assets/${name}.js`);
const { oddity } = globalThis;

const base64 = (numbers) => Buffer.from(new Float64Array(numbers).buffer).toString('base64');

/** A scene whose right model is best known by this algorithm, set by this `resolution`. */
function motionsOf(algorithm, resolution) {
  const setting = resolution === 'step' ? 0.05 : 1e-12;
  const models = [{ name: 'right', algorithms: [algorithm] }, { name: 'published equations', algorithms: ['Runge-Kutta 4'] }];
  const engine = {
    algorithms: [{ name: algorithm, resolution }, { name: 'Runge-Kutta 4', resolution: 'step' }],
    scene: () => ({ models }),
  };
  const data = {
    number: '3.17',
    parameters: [],
    quantities: [{ samples: 10, size: 1, methods: [{ model: 'right', algorithm, precision: 'double', resolution, trials: [[setting, 1e-9, 1, 1, null, 'o']] }] }],
    scene: { quantity: 0, horizon: 1, observables: ['x'], paths: [], close: { m: 0.01 }, norms: [], time_unit: 's',
      truth: { values: base64([0, 1, 2]), frames: 2, end: 1 } },
  };
  const seen = oddity.asPoints;
  oddity.asPoints = () => () => ({ space: false });
  try {
    return oddity.motions(data, engine);
  } finally {
    oddity.asPoints = seen;
  }
}

test('the right motion next to the published one has a setting of the right kind', () => {
  const rowOf = (motions) => motions.asPublished().find((row) => row.model === 'right');
  assert.equal(rowOf(motionsOf('Adams-Bashforth-Moulton 6', 'step')).setting, 0.05);
  assert.equal(rowOf(motionsOf('Fehlberg 7(8)', 'tolerance')).setting, 1e-9);
});
