// Replays every trial of every scene's motion by the page's engine, and compares it with the program's.
//   node replay.mjs engine.js models.js models_nudged.js results.json      (of trials.cpp, or of verify --results).
// The two libraries' sines may differ in their last digit, and nothing else may. The second module shows the
// effect: its functions of the C library are each off by one rounding (nudged.cpp). A trial with fixed steps
// that these do not change uses only + - * / and roots, and must equal the program's bit for bit. In any
// other trial, values in double must agree to 1e-12 of their size; in float, whose roundings are 2^-24, to 16
// of these. A motion that magnifies roundings beyond that, as chaos does, may differ by four times the
// largest effect of the nudged functions in eight runs. The work of fixed steps is the same, unless a
// rounding makes the search for an event end a little sooner or later. The exit code is 1 if a trial differs
// by more, or if it cannot fail.

import { readFileSync } from 'node:fs';
import { performance } from 'node:perf_hooks';
import vm from 'node:vm';

const [engineFile, modelsFile, nudgedFile, resultsFile] = process.argv.slice(2);
const inFloat = ' in float';

async function engineWith(models) {
  const context = vm.createContext({
    atob, performance, Blob, Response, DecompressionStream, TextDecoder, TextEncoder, WebAssembly
  });
  context.window = context;
  for (const file of [engineFile, models]) vm.runInContext(readFileSync(file, 'utf8'), context);
  if (!await context.oddity.engine.ready) throw new Error(`${models} does not run`);
  return context.oddity.engine;
}

// ---- a trial ----------------------------------------------------------------------------------------------------

// The engine's method for a trial, or null.
function asked(engine, number, quantity, trial) {
  const single = trial.algorithm.endsWith(inFloat);
  const algorithm = single ? trial.algorithm.slice(0, -inFloat.length) : trial.algorithm;
  const scene = engine.scene(number);
  if (!scene.models.some(m => m.name === trial.model && m.algorithms.includes(algorithm))) return null;
  return {
    scene: number, model: trial.model, algorithm, precision: single ? 'float' : 'double', setting: trial.resolution,
    times: Float64Array.from([0, ...quantity.trajectory.judged_at])
  };
}

// A run in the form of the results file: values without the start, as far as it came, and the largest drift.
function replayed(engine, method, parameters = {}) {
  const each = engine.scene(method.scene).observables;
  const run = engine.run({...method, parameters});
  const value = Array.from(run.observed).slice(each);
  if (run.last) {
    const came = value.findIndex((x, i) => i % each === 0 && value.slice(i).every(Number.isNaN));
    value.splice(came, value.length, ...run.last);
  }
  const drift = run.drift.reduce((most, x) => (Number.isNaN(most) || Number.isNaN(x) ? NaN : Math.max(most, x)), 0);
  return {value, drift, evaluations: run.evaluations, ending: run.ending};
}

// The program's file has null for numbers that are not finite.
const number = x => (x === null || !Number.isFinite(x) ? NaN : x);

function recorded(trial) {
  const broken = ['non-finite', 'stalled', 'raised', 'chattering', 'grazing'];
  return {
    value: trial.value.map(number), drift: number(trial.drift), evaluations: trial.evaluations,
    ending: broken.includes(trial.outcome) ? trial.outcome : 'reached'
  };
}

const same = (a, b) => a === b || (Number.isNaN(a) && Number.isNaN(b));

function equal(a, b) {
  return a.ending === b.ending && a.value.length === b.value.length &&
    a.value.every((x, i) => same(number(x), number(b.value[i])));
}

// The largest difference relative to the value's size; infinity if the two ended at different times.
function apart(a, b) {
  if (a.ending !== b.ending || a.value.length !== b.value.length) return Infinity;
  const size = Math.max(...b.value.map(Math.abs).filter(Number.isFinite), Number.MIN_VALUE);
  let most = 0;
  a.value.forEach((x, i) => {
    if (!same(number(x), number(b.value[i]))) most = Math.max(most, Math.abs(x - b.value[i]) / size);
  });
  return Number.isNaN(most) ? Infinity : most;
}

// A drift is a difference of sums: its change counts relative to the motion's size. It is not compared if the
// motion broke off, as the file's drift includes the last state.
function driftApart(a, b) {
  if (a.ending !== 'reached' || b.ending !== 'reached') return 0;
  if (same(number(a.drift), number(b.drift))) return 0;
  const change = Math.abs(a.drift - b.drift) / Math.max(1, Math.abs(b.drift));
  return Number.isNaN(change) ? Infinity : change;
}

// ---- its judgement ----------------------------------------------------------------------------------------------

const allowed = {double: 1e-12, float: 16 * 2 ** -24};
const draws = 8, times = 4;

function judged(engines, method, kind, trial) {
  const here = replayed(engines.plain, method), there = recorded(trial);
  const nudged = Array.from({length: draws}, () => replayed(engines.nudged, method));
  const ofOwnSteps = kind.includes('controlled');
  const arithmetic = !ofOwnSteps && nudged.every(other => equal(here, other));
  const difference = apart(here, there), drift = driftApart(here, there);
  const may = allowed[method.precision];
  const far = times * Math.max(...nudged.map(other => apart(other, here)));
  const farDrift = times * Math.max(...nudged.map(other => driftApart(other, here)));
  const sameSteps = here.evaluations === there.evaluations || ofOwnSteps || kind === 'closed form' ||
    here.ending !== 'reached' || nudged.some(other => other.evaluations !== here.evaluations);
  let verdict = 'wrong';
  if (!sameSteps || (difference <= may && drift > Math.max(may, farDrift))) verdict = 'wrong';
  else if (equal(here, there)) verdict = 'equal';
  else if (!arithmetic) verdict = difference <= may ? 'within' : difference <= far ? 'apart' : 'wrong';
  return {verdict, arithmetic, difference, drift, far, farDrift, here, there};
}

// Whether the comparison notices a parameter that is off by a millionth.
function sees(engines, method, trial) {
  const scene = engines.plain.scene(method.scene);
  return scene.parameters.some(name => {
    const moved = replayed(engines.plain, method, {[name]: (scene.defaults[name] || 1) * (1 + 1e-6)});
    return apart(moved, recorded(trial)) > allowed.double;
  });
}

// ---- all of them ------------------------------------------------------------------------------------------------

function replayScene(engines, exercise, quantity) {
  const count = {equal: 0, arithmetic: 0, within: 0, apart: 0, wrong: 0}, missing = new Map(), said = [];
  const blind = new Set(), seen = new Set();
  for (const trial of quantity.trials.concat(...quantity.in_float.map(method => method.trials))) {
    const method = asked(engines.plain, exercise.number, quantity, trial);
    if (!method) {
      const name = engines.plain.scene(exercise.number).models.some(m => m.name === trial.model)
        ? trial.algorithm : `${trial.model}, ${trial.algorithm}`;
      missing.set(name, (missing.get(name) || 0) + 1);
      continue;
    }
    const kind = engines.plain.algorithms.find(a => a.name === method.algorithm).kind;
    const j = judged(engines, method, kind, trial);
    ++count[j.verdict];
    if (j.arithmetic) ++count.arithmetic;
    if (j.verdict === 'wrong' || (j.verdict === 'apart' && method.precision === 'double'))
      said.push(`  ${j.verdict}: ${trial.model}, ${trial.algorithm}, ${trial.resolution}: off by ` +
        `${j.difference.toExponential(1)} (drift ${j.drift.toExponential(1)}), nudged by ` +
        `${(j.far / times).toExponential(1)} (drift ${(j.farDrift / times).toExponential(1)}); ` +
        `${j.here.ending} after ${j.here.evaluations} evaluations, the program ${j.there.ending} after ` +
        `${j.there.evaluations}`);
    if (method.precision === 'double' && trial.value.every(Number.isFinite))
      (seen.has(trial.model) || sees(engines, method, trial) ? seen : blind).add(trial.model);
  }
  for (const model of blind)
    if (!seen.has(model)) { ++count.wrong; said.push(`  wrong: ${model}: no trial of it can fail`); }
  return {count, missing, said};
}

// ---- how long a page's slider takes -----------------------------------------------------------------------------

function timed(engine, number) {
  const frames = Float64Array.from({length: 601}, (_, i) => i / 60);
  const start = performance.now();
  let methods = 0;
  for (const model of engine.scene(number).models)
    for (const name of model.algorithms) {
      const algorithm = engine.algorithms.find(a => a.name === name);
      if (algorithm.resolution === 'tolerance' || algorithm.kind === 'implicit fixed') continue;
      engine.run({
        scene: number, model: model.name, algorithm: name, precision: 'double', setting: 1 / 60, times: frames,
        parameters: {}
      });
      ++methods;
    }
  return {methods, ms: performance.now() - start};
}

const engines = {plain: await engineWith(modelsFile), nudged: await engineWith(nudgedFile)};
const {exercises} = JSON.parse(readFileSync(resultsFile, 'utf8'));
const total = {equal: 0, arithmetic: 0, within: 0, apart: 0, wrong: 0}, allMissing = new Map();
for (const exercise of exercises) {
  const quantity = exercise.quantities.find(q => q.trajectory);
  if (!quantity || !engines.plain.scene(exercise.number)) continue;
  const {count, missing, said} = replayScene(engines, exercise, quantity);
  for (const name of Object.keys(total)) total[name] += count[name];
  for (const [name, n] of missing) allMissing.set(name, (allMissing.get(name) || 0) + n);
  const first = timed(engines.plain, exercise.number);
  const best = Math.min(...Array.from({length: 5}, () => timed(engines.plain, exercise.number).ms));
  console.log(`${exercise.number} ${quantity.name}: ${count.equal} equal, ${count.within} within, ${count.apart} ` +
    `apart, ${count.wrong} wrong (${count.arithmetic} of arithmetic alone); ${first.methods} methods for 10 s at ` +
    `60 Hz in ${first.ms.toFixed(0)} ms, then ${best.toFixed(0)} ms`);
  for (const line of said) console.log(line);
}
console.log(`\nin all ${total.equal + total.within + total.apart + total.wrong} trials: ${total.equal} equal bit for ` +
  `bit, ${total.arithmetic} of them of + - * / and roots alone; ${total.within} within 1e-12 of their size, in float ` +
  `within 16 roundings; ${total.apart} apart, as roundings take them; ${total.wrong} wrong`);
console.log('not replayed, as the module does not have them:');
for (const [name, n] of [...allMissing].sort((a, b) => b[1] - a[1])) console.log(`  ${n} ${name}`);
process.exit(total.wrong === 0 && total.equal > 0 ? 0 : 1);
