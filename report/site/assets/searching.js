// The search for passing methods: every method from coarse to fine, as in `oddity choose`, but on one start
// and without references: the finest run serves as the truth.
(function (oddity) {
  'use strict';

  const margin = 3;
  const nearTie = 1.25;
  const stepsPerFrame = [
    1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 40, 48, 64, 80, 96, 128, 160, 192, 256, 384, 512,
  ];
  const letters = { reached: 'i', 'non-finite': 'N', stalled: 'S', chattering: 'C', grazing: 'G' };

  function frameTimes(state) {
    const frames = Math.max(1, Math.round(state.horizon * state.fps));
    return Float64Array.from({ length: frames + 1 }, (_, i) => i / state.fps);
  }

  /** The setting of an algorithm; one that the engine does not list is a closed form. */
  const resolutionOf = (engine, name) => (engine.algorithms.find((a) => a.name === name) || { resolution: '' }).resolution;

  function settings(resolution, fps) {
    if (resolution === 'step') return stepsPerFrame.map((steps) => 1 / (fps * steps));
    if (resolution === 'tolerance') return Array.from({ length: 12 }, (_, i) => Number('1e-' + (i + 2)));
    return [0];
  }

  /** The largest error in each unit over all frames except the first; NaN if the motion broke off. */
  function errorsOf(observed, truth, scene) {
    const parts = scene.observables.length,
      errors = {};
    for (const { unit, components } of scene.norms) {
      let most = errors[unit] || 0;
      for (let at = parts; at < truth.length; at += parts) {
        let sum = 0;
        for (const c of components) sum += (observed[at + c] - truth[at + c]) ** 2;
        const error = Math.sqrt(sum);
        if (!(error <= most)) most = error; // keeps NaN
        if (Number.isNaN(most)) break;
      }
      errors[unit] = most;
    }
    return errors;
  }

  /** The largest error in needs. */
  const inNeeds = (errors, state) =>
    Math.max(
      ...Object.entries(errors).map(([unit, e]) =>
        Number.isNaN(e) ? Infinity : e / state.errors[unit].value,
      ),
    );

  /** The algorithms of a model that come nearest to the truth, the best first, each at its finest setting. */
  function finest(state, engine, model) {
    const steps = state.horizon * state.fps > 3000 ? 64 : 256;
    return engine.algorithms
      .filter((a) => model.algorithms.includes(a.name) && !a.kind.startsWith('implicit'))
      .sort((a, b) => (a.resolution !== '') - (b.resolution !== '') || b.order - a.order)
      .slice(0, 4)
      .map(({ name, resolution }) => ({
        model: model.name,
        algorithm: name,
        setting: resolution === 'tolerance' ? 1e-13 : resolution === 'step' ? 1 / (steps * state.fps) : 0,
      }));
  }

  /** Runs that may serve as the truth, the best first. */
  function truths(state, engine) {
    const known = engine.scene(state.scene.number).models;
    return state.scene.exact
      .map((name) => known.find((m) => m.name === name))
      .filter(Boolean)
      .flatMap((model) => finest(state, engine, model));
  }

  function trial(state, engine, times, { model, algorithm, precision = 'double', setting }) {
    const before = performance.now();
    const run = engine.run({
      scene: state.scene.number,
      parameters: state.parameters,
      model,
      algorithm,
      precision,
      setting,
      times,
    });
    return { ...run, seconds: run.seconds > 0 ? run.seconds : (performance.now() - before) / 1000 };
  }

  /** The finest run that reaches the end, and its distance from the next best. */
  function* truthOf(state, engine, times) {
    let best = null;
    for (const candidate of truths(state, engine)) {
      const run = trial(state, engine, times, candidate);
      yield;
      if (run.ending !== 'reached' || run.observed.some((x) => !Number.isFinite(x))) continue;
      if (!best) best = { ...candidate, observed: run.observed, errors: null };
      else if (candidate.model !== best.model || candidate.algorithm !== best.algorithm) {
        best.errors = errorsOf(run.observed, best.observed, state.scene);
        best.beside = candidate;
        return best;
      }
    }
    return best;
  }

  function candidates(state, engine) {
    const all = [];
    for (const model of engine.scene(state.scene.number).models)
      for (const algorithm of model.algorithms) {
        const resolution = resolutionOf(engine, algorithm);
        const faulted = state.scene.faulted.includes(model.name);
        const listed = engine.algorithms.find((a) => a.name === algorithm);
        if (state.precision !== 'float')
          all.push({ model: model.name, algorithm, resolution, faulted, precision: 'double' });
        if (state.precision !== 'double' && !model.events && (!listed || listed.inFloat))
          all.push({ model: model.name, algorithm, resolution, faulted, precision: 'float' });
      }
    return all;
  }

  const isMultistep = (name) => /^(Adams-|GSL ms|CVODE)/.test(name);
  const isSimple = (row) => row.resolution !== 'tolerance' && !isMultistep(row.algorithm);

  /** The time of a run: the least of three batches, each long enough for the page's coarse clock. */
  function* timed(run) {
    const batch = (runs) => {
      const before = performance.now();
      for (let i = 0; i < runs; ++i) run();
      return (performance.now() - before) / 1000;
    };
    let runs = 1,
      spent = batch(runs);
    while (spent < 0.004) {
      yield;
      runs *= spent > 0.0005 ? Math.ceil(0.005 / spent) : 4;
      spent = batch(runs);
    }
    let least = spent / runs;
    for (let i = 0; i < 2 && spent < 0.1; ++i) {
      yield;
      least = Math.min(least, batch(runs) / runs);
    }
    return least;
  }

  /** Tries every method from coarse to fine until a setting passes with the margin, then times those that
      pass. Yields after each run; fills `found` meanwhile. */
  function* search(state, engine, found) {
    const times = frameTimes(state),
      frames = times.length - 1;
    found.truth = yield* truthOf(state, engine, times);
    if (!found.truth) return;
    const methods = candidates(state, engine);
    found.all = methods.length;
    const known = found.truth.errors || {};
    for (const method of methods) {
      let spent = 0;
      for (const setting of settings(method.resolution, state.fps)) {
        const run = trial(state, engine, times, { ...method, setting });
        const errors = errorsOf(run.observed, found.truth.observed, state.scene);
        for (const unit of Object.keys(errors)) if (errors[unit] < known[unit]) errors[unit] = known[unit];
        const error = run.ending === 'reached' ? inNeeds(errors, state) : Infinity;
        const row = {
          ...method,
          setting,
          errors,
          error,
          evaluations: run.evaluations,
          frames,
          evaluationsPerFrame: run.evaluations / frames,
          seconds: run.seconds / frames,
          holds: error <= 1,
          outcome: error <= 1 ? 'o' : letters[run.ending] || 'R',
        };
        found.rows.push(row);
        yield;
        spent += run.seconds;
        if (error <= 1 / margin || spent > 0.6 || row.evaluationsPerFrame > 1e5 || row.outcome === 'R') break;
      }
      found.tried += 1;
    }
    for (const row of found.rows.filter((r) => r.holds)) {
      row.seconds = (yield* timed(() => trial(state, engine, times, row))) / frames;
      yield;
    }
    found.done = true;
  }

  /** Picks as `oddity choose` does: a simple method that passes with the margin, otherwise any that passes.
      Takes the cheapest; of near ties the most accurate. Models that their page shows to be wrong are tried,
      but not recommended. {row, ties, simple} or null. */
  function pick(rows, budget) {
    const within = rows.filter((r) => r.holds && !r.faulted && (budget === null || r.seconds <= budget));
    for (const simple of [true, false]) {
      const able = simple ? within.filter((r) => isSimple(r) && r.error <= 1 / margin) : within;
      if (!able.length) continue;
      const least = Math.min(...able.map((r) => r.seconds));
      const ties = able.filter((r) => r.seconds <= nearTie * least);
      const error = Math.min(...ties.map((r) => r.error));
      const good = ties.filter((r) => r.error <= 1.1 * error);
      const row = good.find(isSimple) || good[0];
      return { row, ties: ties.filter((r) => r !== row), simple };
    }
    return null;
  }

  oddity.choosing = Object.assign(oddity.choosing || {}, {
    margin,
    settings,
    frameTimes,
    errorsOf,
    inNeeds,
    search,
    pick,
  });
})((window.oddity = window.oddity || {}));
