// The motions of a typed problem's file, for a player; the counterpart of motions.js for scenes.

(function (oddity) {
  'use strict';

  const kept = 80;            // motions in the cache
  const looks = 20;           // the longest step is a twentieth of the horizon
  const most = 2000;          // frames at which the page judges
  const tight = 1e-12;        // the tolerance of the reference
  const doubles = 1e-11;      // relative to the size: the error at that tolerance
  // Fehlberg 7(8) accepts steps across a kink as exact.
  const integrators = ['Bulirsch-Stoer', 'Dormand-Prince 5(4)'];

  /** The observables of one point are judged by its distance. */
  function normsOf(observables) {
    const norms = [];
    observables.forEach(({ unit, point }, k) => {
      const same = point && norms.find((norm) => norm.point === point);
      if (same) same.components.push(k);
      else norms.push({ unit, point, components: [k] });
    });
    return norms;
  }

  /** `file` as engine.take() resolves to it. */
  oddity.problem = function (file, engine) {
    const models = engine.scene('own').models.map((m) => m.name);
    const methods = oddity.computable('own', engine);
    const count = file.observables.length;
    const observables = file.observables.map((o) => ({ ...o, unit: o.unit === '1' ? '' : o.unit }));
    const units = [...new Set(observables.map((o) => o.unit))];
    const close = Object.fromEntries(units.map((unit, u) => [unit, file.errors[u]]));
    const wanted = Math.max(1, Math.round(file.horizon * file.fps));
    const frames = Math.min(wanted, most);
    const frame = file.horizon / wanted;
    const horizon = frames * frame;         // the page judges only the first frames of a long motion
    const times = oddity.frameTimes(horizon, frames);
    /** "33.3 s of 100 s"; empty for the whole. */
    const part = frames < wanted ? `${oddity.written(horizon)} s of ${oddity.written(file.horizon)} s` : '';
    const norms = normsOf(observables);
    const scene = { observables: observables.map((o) => o.name), horizon, time_unit: 's',
      truth: { frames, end: horizon }, norms, close, varied: file.sweep, paths: [] };
    const quantity = { name: 'motion', samples: looks, methods: [] };
    const data = { number: 'own', title: file.title, parameters: file.parameters, units: file.units, scene,
      quantities: [quantity], file };
    const defaults = Object.fromEntries(file.parameters.map((p) => [p.name, p.value]));
    const cache = new Map();

    const isDefault = (parameters) => file.parameters.every((p) => parameters[p.name] === p.value);
    const find = (model, algorithm) => methods.find((m) => m.model === model && m.algorithm === algorithm);
    const algorithmsOf = (model) => methods.filter((m) => m.model === model);

    function cached(key, make) {
      const name = JSON.stringify(key);
      if (!cache.has(name)) {
        if (cache.size >= kept) cache.delete(cache.keys().next().value);
        cache.set(name, make());
      }
      return cache.get(name);
    }

    const computed = (at, asked) => ({ times: at, count, ...engine.run({ scene: 'own', ...asked, times: at }) });
    const keyOf = (parameters, { model, algorithm, precision, setting }) => [parameters, model, algorithm, precision, setting];

    function run(parameters, method, as = undefined) {
      return cached([...keyOf(parameters, method), as && as.name], () => {
        if (find(method.model, method.algorithm).resolution !== 'step') return computed(times, { parameters, ...method });
        const steps = oddity.timesOfSteps(horizon, looks, frame, method.setting, as);
        return computed(steps.times, { parameters, ...method, setting: steps.step });
      });
    }

    // The last model is the richest, and serves as the reference.
    const last = models[models.length - 1];
    const isClosed = algorithmsOf(last)[0].algorithm === 'closed form';
    const finest = (algorithm) => ({ model: last, algorithm, precision: 'double', setting: tight });
    const richest = isClosed ? { ...finest('closed form'), setting: 0 } : finest(integrators[0]);
    const second = isClosed ? null : finest(integrators[1]);

    const frameByFrame = (parameters, method) =>
      cached(['frames', ...keyOf(parameters, method)], () => computed(times, { parameters, ...method }));
    const truth = (parameters) => frameByFrame(parameters, richest);
    /** The truth at a motion's own times: it need not be smooth between frames. */
    const exactly = (at, parameters) => (at.length === times.length ? truth(parameters)
      : cached(['at', parameters, at.length, at[1], at[at.length - 2]], () => computed(at, { parameters, ...richest })));
    const judge = (motion, parameters) => oddity.judged(motion, exactly(motion.times, parameters), norms, close);

    /** A method's motion at each frame, and its errors there. */
    function judgedByFrame(parameters, method) {
      const motion = computed(times, { parameters, ...method });
      return { motion, judged: oddity.judged(motion, truth(parameters), norms, close) };
    }

    /** The difference of the two references in each unit, which bounds their accuracy. Slow. */
    const apart = (parameters) => cached(['apart', parameters], () => {
      if (!second) return units.map(() => 0);
      const other = frameByFrame(parameters, second);
      if (other.ending !== 'reached' || truth(parameters).ending !== 'reached') return units.map(() => NaN);
      return oddity.judged(other, truth(parameters), norms, close).worst;
    });
    const knownApart = (parameters) => cache.get(JSON.stringify(['apart', parameters])) || null;

    function aboutTruth(parameters) {
      const shown = part ? ` The page looks at the first ${part}.` : '';
      if (isClosed) return `The ghost is the closed form of ${last}, which is taken for true.${shown}`;
      const { ending, message } = truth(parameters);
      const by = `${last} by ${integrators[0]} at a tolerance of ${oddity.written(tight)}`;
      if (ending !== 'reached') return `The true motion is not known to the end by ${by}: ${message || ending}.${shown}`;
      const known = knownApart(parameters);
      const how = !known ? `${integrators[1]} is still to confirm it.`
        : known.every(Number.isFinite) ? `${integrators[1]}, which shares no step with it, differs by ${oddity.amounts(known, units)} at most.`
          : `${integrators[1]} does not get to the end, so nothing confirms it.`;
      return `The ghost is ${by}, which is taken for true. ${how}${shown}`;
    }

    const floors = (parameters, sizes) => {
      const known = knownApart(parameters);
      return sizes.map((x, u) => Math.max(doubles * x, known && known[u] > 0 ? known[u] : 0));
    };

    function usual(method) {
      return method.resolution === 'step' ? frame : method.resolution === 'tolerance' ? 1e-6 : 0;
    }
    const asRow = (method, setting) => ({ model: method.model, algorithm: method.algorithm, precision: 'double', setting });

    /** At a step per frame: a typical engine's method, a better one, and the simplest model. */
    function opening() {
      const plain = find(last, 'symplectic Euler') || find(last, 'semi-implicit Euler') || find(last, 'explicit Euler');
      const rows = [find(last, 'Runge-Kutta 4') || algorithmsOf(last)[0], plain,
        models.length > 1 ? find(models[0], 'Runge-Kutta 4') || algorithmsOf(models[0])[0] : null];
      return rows.filter((m) => m).map((m) => asRow(m, usual(m)));
    }

    // Points are drawn in their plane; other observables over time, relative to their largest value. The true
    // path of each is drawn whole.
    const points = norms.filter((norm) => norm.components.length > 1);
    const reach = (parameters) => cached(['reach', parameters], () => {
      const all = new Float64Array(count);
      truth(parameters).observed.forEach((x, i) => { if (Math.abs(x) > all[i % count]) all[i % count] = Math.abs(x); });
      return all.map((x) => x || 1);
    });
    function placesAt(parameters, t, seen) {
      const size = reach(parameters);
      if (points.length) return points.map(({ components: [x, y] }) => [seen[x], seen[y], 0]);
      return [...seen].map((x, k) => [4 * t / horizon, x / size[k], 0]);
    }
    const ways = (parameters) => cached(['ways', parameters], () => {
      const { observed } = truth(parameters);
      const every = Math.ceil(frames / 400);
      const all = [];
      for (let i = 0; i <= frames; i += every) {
        const seen = observed.subarray(i * count, (i + 1) * count);
        if (!seen.every(Number.isFinite)) break;
        placesAt(parameters, times[i], seen).forEach((at, k) => { (all[k] = all[k] || []).push(at); });
      }
      return all.map((way) => ({ kind: 'guide', points: way, size: 0, letter: '', trail: false }));
    });
    const bodySize = (parameters) => (points.length
      ? Math.max(...points.flatMap((norm) => norm.components.map((k) => reach(parameters)[k]))) / 40 : 0.03);
    function drawing(parameters, t, seen) {
      const size = bodySize(parameters);
      return { space: false, primitives: [...ways(parameters), ...placesAt(parameters, t, seen).map((at) =>
        ({ kind: 'body', points: [at], size, letter: '', trail: true }))] };
    }

    return { data, scene, quantity, frame, looks, defaults, models, methods, find, algorithmsOf, usual, run, truth, judge, floors,
      floorsOf: (motion, floor) => floor, richest, reference: null, seeTruth: oddity.between, apart, aboutTruth, isDefault, opening,
      asPublished: () => null, asEngines: () => null, drawing, recordedOnly: false, space: false,
      units, judgedByFrame, frames, part, isClosed, pointsAreDrawn: points.length > 0 };
  };
})(window.oddity = window.oddity || {});
