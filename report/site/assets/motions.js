// The motions of a scene: computed by the models if the module runs, otherwise recorded.

(function (oddity) {
  'use strict';

  const kept = 60;          // motions in the cache
  const finest = 'Fehlberg 7(8)';
  const byEngine = 'physics engine, as it comes';
  const sevenDigits = 1.2e-7;
  const tenDigits = 1e-10;
  const doubles = 1e-11;      // relative to the size: the error at a tolerance of 1e-12

  const isOk = (outcome) => outcome === 'ok' || outcome === 'o';
  const plain = (algorithm) => algorithm.replace(/ in float$/, '');

  /** The true observables, frame by frame. */
  function recordedTruth({ values, frames, end }, count) {
    return { times: oddity.frameTimes(end, frames), observed: oddity.floats(values), count };
  }

  /** A recorded motion, from frame 1 to its end; `resolution` is the precision of each observable. */
  function recordedPath(path, count, end) {
    const { frames, least, most } = path;
    const observed = new Float64Array((frames + 1) * count).fill(NaN);
    const resolution = new Float64Array(count);
    if (least) {
      for (let k = 0; k < count; k += 1) resolution[k] = (most[k] - least[k]) / 65535;
      oddity.fromChanges(path.values, count).forEach((x, i) => { observed[count + i] = least[i % count] + x * resolution[i % count]; });
    } else {
      observed.set(oddity.floats(path.values), count);
    }
    return { times: oddity.frameTimes(end, frames), observed, count, resolution };
  }

  /** The page's data on the scene's methods, by "model, algorithm". */
  function methodsOf(quantity) {
    const all = new Map();
    for (const m of quantity.methods) {
      const name = `${m.model}, ${plain(m.algorithm)}`;
      const known = all.get(name) || { model: m.model, algorithm: plain(m.algorithm), resolution: m.resolution, trials: [] };
      if (m.precision === 'double') Object.assign(known, { resolution: m.resolution, trials: m.trials });
      all.set(name, known);
    }
    return [...all.values()];
  }

  const bestTrial = (method) => method.trials.reduce((best, t) => (t[1] !== null && isOk(t[5]) && !(best && best[1] <= t[1]) ? t : best), null);

  /** Methods that the module can run. */
  oddity.computable = function (number, engine) {
    const own = engine.scene(number);
    if (!own) return [];
    const facts = new Map(engine.algorithms.map((a) => [a.name, a]));
    return own.models.flatMap(({ name, algorithms, events }) => algorithms.map((algorithm) => {
      const fact = facts.get(algorithm) || { resolution: '', inFloat: false };
      return { model: name, algorithm, resolution: fact.resolution, precisions: fact.inFloat && !events ? ['double', 'float'] : ['double'] };
    }));
  };

  /** Recorded methods that the module lacks, at their only setting. */
  function recordedMethods(paths, others) {
    return paths
      .filter((p) => !others.some((m) => m.model === p.model && m.algorithm === p.algorithm))
      .map((p) => ({ model: p.model, algorithm: p.algorithm, resolution: p.resolution, precisions: [p.precision || 'double'], path: p }));
  }

  /** An outcome's name, by its letter. */
  oddity.outcomeName = (data, outcome) => (data.outcomes && data.outcomes[outcome]) || outcome;

  oddity.motions = function (data, engine) {
    const { scene } = data;
    const quantity = data.quantities[scene.quantity];
    const frame = scene.truth.end / scene.truth.frames;
    const looks = quantity.samples;
    const count = scene.observables.length;
    const defaults = Object.fromEntries(data.parameters.map((p) => [p.name, p.value]));
    const tried = methodsOf(quantity);
    const computed = engine ? oddity.computable(data.number, engine) : [];
    const methods = [...computed, ...recordedMethods(scene.paths, computed)];
    const cache = new Map();
    const isDefault = (parameters) => data.parameters.every((p) => parameters[p.name] === p.value);
    const find = (model, algorithm) => methods.find((m) => m.model === model && m.algorithm === algorithm);
    const triedLike = (m) => tried.find((t) => t.model === m.model && t.algorithm === m.algorithm);

    function cached(key, make) {
      if (!cache.has(key)) {
        if (cache.size >= kept) cache.delete(cache.keys().next().value);
        cache.set(key, make());
      }
      return cache.get(key);
    }

    function compute(parameters, { model, algorithm, precision, setting }, as) {
      const { resolution } = find(model, algorithm);
      const steps = resolution === 'step' ? oddity.timesOfSteps(scene.horizon, looks, frame, setting, as) : null;
      const times = steps ? steps.times : oddity.frameTimes(scene.horizon, scene.truth.frames);
      return computedAt(times, { parameters, model, algorithm, precision, setting: steps ? steps.step : setting });
    }

    /** Incompatible parameters give a motion without frames. */
    function computedAt(times, asked) {
      try {
        return { times, count, ...engine.run({ scene: data.number, ...asked, times }) };
      } catch (error) {
        const nothing = new Float64Array(0);
        return { times, count, observed: new Float64Array(times.length * count).fill(NaN), drift: nothing, off: nothing,
          ending: 'raised', message: 'with these parameters it cannot start' };
      }
    }

    function replay(path) {
      return { ...recordedPath(path, count, scene.horizon), drift: new Float64Array(0), off: new Float64Array(0),
        ending: oddity.outcomeName(data, path.outcome) === 'non-finite' ? 'non-finite' : 'reached', message: '' };
    }

    /** A method's motion; null if only another set of parameters is recorded. `as`, one of framesAs, sets the frames' lengths. */
    function run(parameters, method, as = undefined) {
      const { path } = find(method.model, method.algorithm);
      if (path) return isDefault(parameters) ? cached(path, () => replay(path)) : null;
      const key = JSON.stringify([parameters, method.model, method.algorithm, method.precision, method.setting, as && as.name]);
      return cached(key, () => compute(parameters, method, as));
    }

    /** The reference if none is recorded: an integrated model with all of the physics, at its finest setting.
        */
    function finestMethod() {
      const candidates = computed.filter((m) => triedLike(m) && bestTrial(triedLike(m)));
      const error = (m) => bestTrial(triedLike(m))[1];
      const best = (some) => some.reduce((a, b) => (a && error(a) <= error(b) ? a : b), null);
      const usual = best(candidates.filter((m) => m.algorithm === finest));
      const smooth = usual && error(usual) <= tenDigits * quantity.size;  // else its adaptive steps meet a kink
      const method = smooth ? usual : best(candidates.filter((m) => m.resolution)) || best(candidates);
      return method && { model: method.model, algorithm: method.algorithm, precision: 'double', error: error(method),
        setting: method.resolution === 'tolerance' ? 1e-12 : bestTrial(triedLike(method))[0] };
    }
    const richest = engine ? (data.example && data.example.truth) || finestMethod() : null;

    /** The recorded truth; a missing frame 0 is taken from the finest method. */
    const reference = recordedTruth(scene.truth, count);
    if (richest && !Number.isFinite(reference.observed[0])) reference.observed.set(run(defaults, richest).observed.subarray(0, count));

    const frames = (parameters) => {
      const key = JSON.stringify(['truth', parameters]);
      return cached(key, () => computedAt(oddity.frameTimes(scene.horizon, scene.truth.frames), { parameters, ...richest }));
    };

    const truth = (parameters) => (isDefault(parameters) || !richest ? reference : frames(parameters));

    /** The truth at a motion's own times: with events it is not smooth between frames. */
    const exactly = (times, parameters) => ({ ...truth(parameters), ...computedAt(times, { parameters, ...richest }) });
    const judge = (motion, parameters) => oddity.judged(motion,
      data.example && richest ? exactly(motion.times, parameters) : truth(parameters), scene.norms, scene.close);

    /** Error of the finest method against the recorded truth, in each unit. */
    const apart = () => cached('apart', () => oddity.judged(frames(defaults), reference, scene.norms, scene.close).worst);

    /** Errors below this are invisible, in each unit. A recorded truth has seven digits; a computed one is as
        accurate as the finest method in the table, or as its measured difference if that exceeds seven
        digits. */
    function floors(parameters, sizes) {
      const digits = sizes.map((x) => sevenDigits * x);
      if (truth(parameters) === reference) return digits;
      return apart().map((x, u) => (x > 2 * digits[u] ? x : Math.max(doubles * sizes[u], richest.error || 0)));
    }

    /** Errors below this are invisible for a motion that may be recorded, in each unit. */
    function floorsOf(motion, floor) {
      if (!motion || !motion.resolution) return floor;
      const units = Object.keys(scene.close);
      const zero = new Float64Array(count);
      return oddity.distances(motion.resolution, zero, scene.norms, units).map((x, u) => Math.max(x, floor[u]));
    }

    const asRow = ({ model, algorithm, precisions, resolution, path }, setting) => ({ model, algorithm, precision: precisions[0],
      setting: path ? path.setting : resolution ? setting : 0 });

    /** A setting for a newly chosen method. */
    function usual(method) {
      if (method.path) return method.path.setting;
      if (method.resolution === 'step') return frame;
      if (method.resolution === 'tolerance') return 1e-6;
      const known = triedLike(method);
      return known && known.trials.length ? known.trials[known.trials.length >> 1][0] : 0;
    }

    const models = [...new Set(methods.map((m) => m.model))];
    const algorithmsOf = (model) => methods.filter((m) => m.model === model);

    /** The model that the study solves by the most algorithms: an engine's likely choice. */
    function engines() {
      const count = (model) => tried.filter((t) => t.model === model).length;
      return models.filter((m) => !oddity.isPublished(m) && find(m, 'explicit Euler')).sort((a, b) => count(b) - count(a))[0];
    }

    /** The cheapest method that is enough for a game, and a typical engine's. */
    function opening() {
      if (data.example && computed.length) return data.example.opening;
      const rows = [];
      const least = (data.least || [])[0];
      const enough = least && find(least.model, least.algorithm);
      if (enough) rows.push(asRow(enough, least.setting));
      const model = engines();
      for (const algorithm of ['symplectic Euler', 'explicit Euler'])
        if (model && find(model, algorithm) && !find(model, algorithm).path)
          rows.push(asRow(find(model, algorithm), frame));
      return rows.length > 1 ? rows : [...rows, ...fromRecorded(rows)].slice(0, 2);
    }

    /** A recorded motion that is right, and one that is not. */
    function fromRecorded(rows) {
      const others = methods.filter((m) => m.path && m.model !== byEngine && !rows.some((r) => r.model === m.model));
      const right = others.filter((m) => isOk(m.path.outcome));
      const wrong = others.filter((m) => !isOk(m.path.outcome))
        .sort((a, b) => oddity.isPublished(b.model) - oddity.isPublished(a.model));
      return (rows.length ? [...wrong, ...right] : [...right.slice(0, 1), ...wrong, ...right.slice(1)]).map((m) => asRow(m));
    }

    /** Compares the published model by its finest algorithm with the finest method. */
    function asPublished() {
      const finestOf = (model) => {
        const all = algorithmsOf(model);
        const method = all.find((m) => m.algorithm === finest) || all.find((m) => m.algorithm === 'Runge-Kutta 4') || all[0];
        return asRow(method, method.resolution === 'tolerance' ? 1e-9 : frame / 4);
      };
      const right = richest || null;
      const printed = models.filter(oddity.isPublished).map(finestOf);
      if (!printed.length) return null;
      if (!right) return printed.slice(0, 4);
      const method = find(right.model, right.algorithm);
      return [asRow(method, method.resolution === 'tolerance' ? 1e-9 : right.setting), ...printed].slice(0, 4);
    }

    /** Third-party engines, the worst and the best, with a method that is enough; null if none was run. */
    function asEngines() {
      const ran = algorithmsOf(byEngine).sort((a, b) => b.path.error - a.path.error);
      if (!ran.length) return null;
      const some = [...new Set([ran[0], ran[ran.length >> 1], ran[ran.length - 1]])];
      return [...opening().slice(0, 1), ...some.map((m) => asRow(m))];
    }

    /** The truth at any time. */
    const seeTruth = data.example ? oddity.between : oddity.throughSix;

    const own = engine && engine.scene(data.number);
    const drawing = own && own.drawn
      ? (parameters, t, observed) => engine.draw(data.number, parameters, t, observed) : oddity.asPoints(data);

    return { data, scene, quantity, frame, looks, defaults, models, methods, find, algorithmsOf, usual, run, truth, judge, floors, floorsOf, richest,
      reference, seeTruth, apart, isDefault, opening, asPublished, asEngines, drawing, recordedOnly: !computed.length,
      space: drawing(defaults, 0, reference.observed.slice(count, 2 * count)).space };
  };

  /** The drawing of a scene that defines none: its observables as points if their names allow it, otherwise
      over time. */
  oddity.asPoints = function (data) {
    const { observables, horizon, truth } = data.scene;
    const values = oddity.floats(truth.values);
    let reach = 0;
    for (const x of values) if (Math.abs(x) > reach) reach = Math.abs(x);
    const size = reach / 40;
    const ball = (points, space) => ({ space, primitives: points.map((p) =>
      ({ kind: 'body', points: [p], size, letter: '', trail: true })) });
    const names = observables.join();
    if (/^x1?,(y|x2)1?(,(z|x3|psi|theta))?$/.test(names) || /^x1,y1/.test(names)) {
      const space = /z$|x3$/.test(names);
      const each = space ? 3 : 2;
      const flat = /psi|theta/.test(names) ? 2 : observables.length;
      return (parameters, t, o) => {
        const points = [];
        for (let k = 0; k + each <= flat; k += each) points.push([o[k], o[k + 1], space ? o[k + 2] : 0]);
        return ball(points, space);
      };
    }
    return (parameters, t, o) => ball([...o].map((x) => [t / horizon * 4 * reach, x, 0]), false);
  };
})(window.oddity = window.oddity || {});
