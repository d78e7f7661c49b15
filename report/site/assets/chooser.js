// The chooser: which model, algorithm and step are enough for a game, computed in the page. It searches as
// `oddity choose` does, on one start and without references: the finest run stands for the truth.
(function (oddity) {
  'use strict';

  const { number, count, duration, element, chart, said } = oddity.charts;

  const mostFrames = 36000;
  const margin = 3;
  const nearTie = 1.25;
  const stepsPerFrame = [
    1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 40, 48, 64, 80, 96, 128, 160, 192, 256, 384, 512,
  ];
  const sizes = {
    m: { m: 1, cm: 0.01, mm: 0.001, km: 1000 },
    rad: { rad: 1, deg: Math.PI / 180, '°': Math.PI / 180 },
    s: { s: 1, ms: 1e-3, us: 1e-6, µs: 1e-6, ns: 1e-9, min: 60, h: 3600 },
  };
  const letters = { reached: 'i', 'non-finite': 'N', stalled: 'S', chattering: 'C', grazing: 'G' };
  const outcomes = {
    o: 'holds',
    i: 'inaccurate',
    N: 'non-finite',
    S: 'stalled',
    C: 'chattering',
    G: 'grazing',
    R: 'raised',
  };

  // ---- what is asked ---------------------------------------------------------------------------------------

  /** "1 cm" as {value: 0.01, text: "1cm"} in the base unit; null where it makes no sense. */
  function asked(text, base) {
    const found = /^\s*([0-9]*\.?[0-9]+(?:e[-+]?[0-9]+)?)\s*(\S*)\s*$/i.exec(text);
    if (!found) return null;
    const units = sizes[base] || {};
    const size = found[2] === '' || found[2] === base ? 1 : units[found[2]];
    const value = Number(found[1]) * size;
    if (!size || !(value > 0) || !Number.isFinite(value)) return null;
    return { value, text: found[1] + (sizes[base] ? found[2].replace('°', 'deg').replace('µ', 'u') : '') };
  }

  const unitsOf = (scene) => Object.keys(scene.close);
  const usualError = (scene, unit) =>
    unit === 'm' ? '1 cm' : unit === 'rad' ? '1 deg' : String(Number(scene.close[unit].toPrecision(3)));

  /** What a page begins with. */
  function usual(scene) {
    return {
      scene,
      parameters: Object.fromEntries(scene.parameters.map((p) => [p.name, p.value])),
      horizon: 10,
      fps: 60,
      errors: Object.fromEntries(unitsOf(scene).map((unit) => [unit, asked(usualError(scene, unit), unit)])),
      budget: null,
      precision: 'double',
    };
  }

  function setParameter(state, p, text) {
    const value = Number(text);
    const least = p.least === null ? -Infinity : p.least,
      most = p.most === null ? Infinity : p.most;
    if (text.trim() === '' || !Number.isFinite(value))
      throw new Error(`${p.name} is a number, not "${text}"`);
    if (value < least || value > most)
      throw new Error(`${p.name} = ${text} is out of its range: ${number(least, 6)} to ${number(most, 6)}`);
    if (p.whole && !Number.isInteger(value)) throw new Error(`${p.name} is a whole number, not "${text}"`);
    state.parameters[p.name] = value;
  }

  function setPositive(state, key, text, says) {
    const value = Number(text);
    if (text.trim() === '' || !(value > 0) || !Number.isFinite(value))
      throw new Error(`${says} is a number above zero, not "${text}"`);
    state[key] = value;
  }

  function setErrors(state, texts) {
    unitsOf(state.scene).forEach((unit, i) => {
      const found = asked(texts.length === 1 ? texts[0] : texts[i] || '', unit);
      if (!found)
        throw new Error(
          `an error in ${unit} is a number above zero${sizes[unit] ? ', such as 1 ' + Object.keys(sizes[unit])[1] : ''}, not "${texts[i] || texts[0]}"`,
        );
      state.errors[unit] = found;
    });
  }

  function setBudget(state, text) {
    if (text.trim() === '') {
      state.budget = null;
      return;
    }
    const found = asked(text, 's');
    if (!found) throw new Error(`a budget is a time, such as 5us, not "${text}"`);
    state.budget = { value: found.value, text: found.text };
  }

  function setPrecision(state, text) {
    if (!['double', 'float', 'any'].includes(text))
      throw new Error(`a precision is double, float or any, not "${text}"`);
    state.precision = text;
  }

  /** The pendulum, which everybody knows. */
  const first = (scenes) => scenes.find((s) => s.number === '3.5') || scenes[0];

  /** What a link asks for: "#scene=3.5&a=0.6&error=1deg". Throws what is wrong with it. */
  function fromHash(hash, scenes) {
    const pairs = [...new URLSearchParams(hash.replace(/^#/, ''))];
    const wanted = new Map(pairs).get('scene');
    const scene = wanted === undefined ? first(scenes) : scenes.find((s) => s.number === wanted);
    if (!scene)
      throw new Error(`there is no scene "${wanted}"; there are ${scenes.map((s) => s.number).join(', ')}`);
    const state = usual(scene);
    for (const [key, text] of pairs) {
      const p = scene.parameters.find((parameter) => parameter.name === key);
      if (key === 'scene') continue;
      else if (key === 'horizon') setPositive(state, 'horizon', text, 'the horizon');
      else if (key === 'fps') setPositive(state, 'fps', text, 'the frame rate');
      else if (key === 'error') setErrors(state, text.split(','));
      else if (key === 'budget') setBudget(state, text);
      else if (key === 'precision') setPrecision(state, text);
      else if (p) setParameter(state, p, text);
      else throw new Error(`scene ${scene.number} has no parameter "${key}"`);
    }
    return state;
  }

  const changed = (state) =>
    state.scene.parameters
      .filter((p) => state.parameters[p.name] !== p.value)
      .map((p) => [p.name, String(state.parameters[p.name])]);
  const errorText = (state) =>
    unitsOf(state.scene)
      .map((unit) => state.errors[unit].text)
      .join(',');

  function toHash(state) {
    const pairs = [['scene', state.scene.number], ...changed(state), ['error', errorText(state)]];
    if (state.horizon !== 10) pairs.push(['horizon', String(state.horizon)]);
    if (state.fps !== 60) pairs.push(['fps', String(state.fps)]);
    if (state.budget) pairs.push(['budget', state.budget.text]);
    if (state.precision !== 'double') pairs.push(['precision', state.precision]);
    return '#' + new URLSearchParams(pairs);
  }

  /** The command whose answer is judged by references. */
  function command(state) {
    return [
      'oddity choose',
      state.scene.number,
      ...changed(state).map(([name, value]) => name + '=' + value),
      '--error ' + errorText(state),
      '--horizon ' + state.horizon,
      '--fps ' + state.fps,
      ...(state.budget ? ['--budget ' + state.budget.text] : []),
      ...(state.precision !== 'double' ? ['--precision ' + state.precision] : []),
    ].join(' ');
  }

  // ---- trying ----------------------------------------------------------------------------------------------

  function frameTimes(state) {
    const frames = Math.max(1, Math.round(state.horizon * state.fps));
    return Float64Array.from({ length: frames + 1 }, (_, i) => i / state.fps);
  }

  /** The knob of an algorithm; what the engine does not list is a closed form. */
  const knobOf = (engine, name) => (engine.algorithms.find((a) => a.name === name) || { knob: '' }).knob;

  function settings(knob, fps) {
    if (knob === 'step') return stepsPerFrame.map((steps) => 1 / (fps * steps));
    if (knob === 'tolerance') return Array.from({ length: 12 }, (_, i) => Number('1e-' + (i + 2)));
    return [0];
  }

  /** The largest error in each unit over all frames but the first; not a number where the motion broke off. */
  function errorsOf(observed, truth, scene) {
    const parts = scene.observables.length,
      errors = {};
    for (const { unit, components } of scene.norms) {
      let most = errors[unit] || 0;
      for (let at = parts; at < truth.length; at += parts) {
        let sum = 0;
        for (const c of components) sum += (observed[at + c] - truth[at + c]) ** 2;
        const error = Math.sqrt(sum);
        if (!(error <= most)) most = error; // not a number stays
        if (Number.isNaN(most)) break;
      }
      errors[unit] = most;
    }
    return errors;
  }

  /** The largest error in parts of what is asked. */
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
      .sort((a, b) => (a.knob !== '') - (b.knob !== '') || b.order - a.order)
      .slice(0, 4)
      .map(({ name, knob }) => ({
        model: model.name,
        algorithm: name,
        setting: knob === 'tolerance' ? 1e-13 : knob === 'step' ? 1 / (steps * state.fps) : 0,
      }));
  }

  /** The runs that may stand for the truth, the best first. */
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

  /** The finest run that comes to its end, and how far the next best is from it. */
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
        const knob = knobOf(engine, algorithm);
        const listed = engine.algorithms.find((a) => a.name === algorithm);
        if (state.precision !== 'float')
          all.push({ model: model.name, algorithm, knob, precision: 'double' });
        if (state.precision !== 'double' && !model.events && (!listed || listed.inFloat))
          all.push({ model: model.name, algorithm, knob, precision: 'float' });
      }
    return all;
  }

  const isMultistep = (name) => /^(Adams-|ms|CVODE)/.test(name);
  /** Models that have the book's errors in them are tried, and not advised. */
  const isPublished = (row) => /as published|printed listing/.test(row.model);
  const isSimple = (row) =>
    row.knob !== 'tolerance' && !isMultistep(row.algorithm) && !row.algorithm.startsWith('linearly implicit');

  /** How long a run takes: the least of three batches, each long enough for the page's coarse clock. */
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

  /** Tries every method from coarse to fine until one holds with the margin, then times what holds. Yields after
   *  each run; `found` fills meanwhile. */
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
      for (const setting of settings(method.knob, state.fps)) {
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

  /** As `oddity choose` picks: a simple method that holds with the margin, else what holds; of those the
   *  cheapest, of near ties the most accurate. {row, ties, simple} or null. */
  function pick(rows, budget) {
    const within = rows.filter((r) => r.holds && !isPublished(r) && (budget === null || r.seconds <= budget));
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

  // ---- saying ----------------------------------------------------------------------------------------------

  const settingOf = (row, fps) => {
    if (!row.knob) return '';
    if (row.knob === 'tolerance') return 'tolerance ' + number(row.setting, 1);
    const steps = Math.round(1 / (row.setting * fps));
    return steps + (steps === 1 ? ' step a frame' : ' steps a frame');
  };

  function errorIn(errors, state) {
    return unitsOf(state.scene)
      .map((unit) => {
        const [, symbol] = /^[0-9.]+(?:e[-+]?[0-9]+)?(.*)$/i.exec(state.errors[unit].text) || [];
        const size = symbol ? sizes[unit][symbol] : 1;
        const shown = symbol === 'deg' ? '°' : ' ' + (symbol || unit);
        return number(errors[unit] / size, 2) + shown;
      })
      .join(' and ');
  }

  const methodText = (row) =>
    (row.knob ? row.algorithm : row.model + ' by ' + row.algorithm) +
    (row.precision === 'float' ? ' in float' : '') +
    (row.knob ? ' on the model "' + row.model + '"' : '');

  const evaluationsText = (x) => number(x, 3) + (x === 1 ? ' evaluation' : ' evaluations');

  /** The answer in sentences. */
  function answer(state, found) {
    const chosen = pick(found.rows, state.budget ? state.budget.value : null);
    if (!chosen) {
      const held = found.rows.filter((r) => r.holds).sort((a, b) => a.seconds - b.seconds)[0];
      if (held)
        return [
          'Nothing here holds within the budget.',
          'The nearest is ' + methodText(held) + ': ' + duration(1e9 * held.seconds) + ' a frame.',
        ];
      const best = [...found.rows].sort((a, b) => a.error - b.error)[0];
      return [
        'Nothing here meets that.',
        best && Number.isFinite(best.error)
          ? 'The closest is ' +
            methodText(best) +
            (best.knob ? ', ' + settingOf(best, state.fps) : '') +
            ', with an error of ' +
            errorIn(best.errors, state) +
            '.'
          : '',
      ];
    }
    const { row, ties, simple } = chosen;
    const setting = settingOf(row, state.fps);
    const lines = [
      'Take ' +
        methodText(row) +
        (setting ? ', ' + setting : '') +
        ': ' +
        evaluationsText(row.evaluationsPerFrame) +
        ' and ' +
        duration(1e9 * row.seconds) +
        ' a frame in this page.',
    ];
    lines.push(
      'Its error is ' +
        errorIn(row.errors, state) +
        ' at most, ' +
        (row.error > 0 ? number(1 / row.error, 2) + ' times better than asked' : 'nothing that can be seen') +
        (simple ? '.' : '; nothing simpler holds with a margin of ' + margin + '.'),
    );
    const { truth } = found;
    if (row.model === truth.model && row.algorithm === truth.algorithm && row.precision === 'double')
      lines[1] =
        'It is what this page takes for the truth' +
        (truth.errors ? ', which is known to ' + errorIn(truth.errors, state) : '') +
        '.';
    if (state.budget)
      lines.push('That is ' + number((100 * row.seconds) / state.budget.value, 2) + ' % of the budget.');
    const other = [...new Set(ties.map(methodText))].slice(0, 3);
    if (other.length) lines.push('It costs about the same as ' + other.join('; ') + '.');
    return lines;
  }

  const describe = (t, fps) =>
    '"' +
    t.model +
    '" by ' +
    t.algorithm +
    (t.setting >= 1e-10
      ? ', ' + Math.round(1 / (t.setting * fps)) + ' steps a frame'
      : t.setting
        ? ' at tolerance ' + number(t.setting, 1)
        : '');

  function truthText(state, truth) {
    const away = truth.errors
      ? '; ' + describe(truth.beside, state.fps) + ' is at most ' + errorIn(truth.errors, state) + ' from it'
      : '';
    const doubtful = truth.errors && inNeeds(truth.errors, state) > 0.1;
    return (
      'This page has no reference. It takes for the truth ' +
      describe(truth, state.fps) +
      away +
      '.' +
      (doubtful
        ? ' That is not far below what is asked: the motion may be chaotic, and no answer here is safe.'
        : '') +
      ' One start is tried. The command below is judged by references, on this start and on five beside it.'
    );
  }

  // ---- the page --------------------------------------------------------------------------------------------

  /** The results as a quantity that a chart can show. */
  function quantityOf(state, found) {
    const units = unitsOf(state.scene),
      single = units.length === 1;
    const methods = new Map();
    for (const row of found.rows) {
      const key = [row.model, row.algorithm, row.precision].join('|');
      if (!methods.has(key))
        methods.set(key, {
          model: row.model,
          algorithm: row.algorithm,
          precision: row.precision,
          knob: row.knob,
          trials: [],
        });
      const error = single ? row.errors[units[0]] : row.error;
      methods
        .get(key)
        .trials.push([
          row.setting,
          Number.isFinite(error) ? error : null,
          row.evaluations,
          1e9 * row.seconds * row.frames,
          null,
          row.outcome,
        ]);
    }
    const truth = single && found.truth.errors ? found.truth.errors[units[0]] : 0;
    const need = single ? state.errors[units[0]].value : 1;
    return {
      name: 'choice',
      unit: single ? units[0] : '',
      need,
      floor: Math.max(truth, need * 1e-14),
      size: need,
      samples: 1,
      says: single
        ? 'error over all frames, judged by the finest run'
        : 'error over all frames in parts of what is asked, judged by the finest run',
      asked: errorText(state).replace(',', ' and ').replace(/deg/g, '°'),
      charts: ['evaluations', 'time'],
      methods: [...methods.values()],
    };
  }

  function resultTable(state, found, chosen) {
    const methods = new Map();
    for (const row of found.rows) {
      const key = [row.model, row.algorithm, row.precision].join('|'),
        mine = methods.get(key);
      const better =
        !mine || (row.holds && (!mine.holds || row === chosen)) || (!mine.holds && row.error < mine.error);
      if (better && mine !== chosen) methods.set(key, row);
    }
    const rows = [...methods.values()].sort(
      (a, b) => b.holds - a.holds || (a.holds ? a.seconds - b.seconds : a.error - b.error),
    );
    const head = ['model', 'algorithm', 'setting', 'error', 'evaluations a frame', 'time a frame', 'outcome'];
    const body = element(
      'tbody',
      {},
      ...rows.map((r) =>
        element(
          'tr',
          { class: r === chosen ? 'lit' : undefined },
          element('th', { scope: 'row' }, r.model),
          element('td', {}, r.algorithm + (r.precision === 'float' ? ' in float' : '')),
          element('td', {}, settingOf(r, state.fps)),
          element('td', { class: 'number' }, errorIn(r.errors, state)),
          element('td', { class: 'number' }, number(r.evaluationsPerFrame, 3)),
          element('td', { class: 'number' }, duration(1e9 * r.seconds)),
          element('td', {}, r === chosen ? 'chosen' : outcomes[r.outcome]),
        ),
      ),
    );
    return element(
      'table',
      {},
      element('caption', {}, 'Each method at its cheapest setting that holds, or else at its best'),
      element('thead', {}, element('tr', {}, ...head.map((text) => element('th', { scope: 'col' }, text)))),
      body,
    );
  }

  function labelled(text, input, note) {
    return element(
      'label',
      {},
      element('span', {}, text),
      input,
      ...(note ? [element('small', {}, note)] : []),
    );
  }

  function rangeText(p) {
    if (p.least === null || p.most === null) return p.unit;
    return number(p.least, 3) + ' to ' + number(p.most, 3) + (p.unit && p.unit !== '1' ? ' ' + p.unit : '');
  }

  function chooser(place) {
    const scenes = oddity.allScenes || [];
    let state = null,
      engine = null,
      running = 0,
      axis = 'evaluations';
    const message = element('p', { class: 'message', role: 'alert' });
    const form = element('form', { class: 'asked' });
    const result = element('div', { class: 'answer', role: 'status' });
    const figure = element('figure', { class: 'chart' });
    const table = element('div', {
      class: 'scroll',
      tabindex: '0',
      role: 'region',
      'aria-label': 'methods tried',
    });
    const code = element('code');
    const copy = element('button', { type: 'button' }, 'copy');
    const commandLine = element('p', { class: 'command' }, code, ' ', copy);
    const truth = element('p', { class: 'says' });
    place.replaceChildren(
      message,
      form,
      result,
      truth,
      commandLine,
      figure,
      element('details', {}, element('summary', {}, 'Every method as a table'), table),
    );
    form.addEventListener('submit', (event) => event.preventDefault());
    copy.addEventListener('click', () => {
      const range = document.createRange();
      range.selectNodeContents(code);
      getSelection().removeAllRanges();
      getSelection().addRange(range);
      if (document.execCommand('copy')) copy.textContent = 'copied';
    });

    function read(act) {
      try {
        message.textContent = '';
        act();
        history.replaceState(null, '', toHash(state));
        start();
      } catch (error) {
        message.textContent = error.message[0].toUpperCase() + error.message.slice(1) + '.';
      }
    }

    function field(value, act, attributes = {}) {
      const input = element('input', {
        type: 'text',
        autocomplete: 'off',
        spellcheck: 'false',
        value,
        ...attributes,
      });
      input.addEventListener('change', () => read(() => act(input.value)));
      return input;
    }

    function selection(options, value, act) {
      const select = element(
        'select',
        {},
        ...options.map(([key, text]) => element('option', { value: key }, text)),
      );
      select.value = value;
      select.addEventListener('change', () => read(() => act(select.value)));
      return select;
    }

    function build() {
      const { scene } = state;
      const used = engine && engine.scene(scene.number) ? engine.scene(scene.number).parameters : null;
      const numbers = { inputmode: 'decimal' };
      const start = scene.parameters.filter((p) => p.name !== 'seed' && (!used || used.includes(p.name)));
      form.replaceChildren(
        labelled(
          'scene',
          selection(
            scenes.map((s) => [s.number, s.number + ' ' + s.title]),
            scene.number,
            (value) => {
              state = {
                ...usual(scenes.find((s) => s.number === value)),
                fps: state.fps,
                precision: state.precision,
              };
              build();
            },
          ),
        ),
        element(
          'fieldset',
          {},
          element('legend', {}, 'start'),
          ...start.map((p) =>
            labelled(
              p.name,
              field(String(state.parameters[p.name]), (text) => setParameter(state, p, text), numbers),
              p.says + ', ' + rangeText(p),
            ),
          ),
        ),
        element(
          'fieldset',
          {},
          element('legend', {}, 'what is asked'),
          ...unitsOf(scene).map((unit) =>
            labelled(
              'error [' + unit + ']',
              field(state.errors[unit].text, (text) => {
                const found = asked(text, unit);
                if (!found) throw new Error(`an error in ${unit} is a number above zero, not "${text}"`);
                state.errors[unit] = found;
              }),
            ),
          ),
          labelled(
            'horizon [' + scene.time_unit + ']',
            field(
              String(state.horizon),
              (text) => setPositive(state, 'horizon', text, 'the horizon'),
              numbers,
            ),
          ),
          labelled(
            scene.time_unit === 's' ? 'frames a second' : 'frames a ' + scene.time_unit,
            field(String(state.fps), (text) => setPositive(state, 'fps', text, 'the frame rate'), numbers),
          ),
          labelled(
            'budget a frame',
            field(state.budget ? state.budget.text : '', (text) => setBudget(state, text), {
              placeholder: 'none, or 5us',
            }),
          ),
          labelled(
            'precision',
            selection(
              [
                ['double', 'double'],
                ['float', 'float'],
                ['any', 'either'],
              ],
              state.precision,
              (value) => setPrecision(state, value),
            ),
          ),
        ),
      );
    }

    function draw(found, last) {
      const chosen = last ? pick(found.rows, state.budget ? state.budget.value : null) : null;
      const quantity = quantityOf(state, found);
      const pressed = figure.querySelector('.choice [aria-pressed=true]');
      if (pressed) axis = pressed.textContent === 'time' ? 'time' : 'evaluations';
      if (axis === 'time') quantity.charts.reverse();
      chart(figure, quantity, {
        styles: state.scene.styles,
        outcomes,
        timeUnit: state.scene.time_unit,
        game: null,
        close: [],
        plays: false,
        floats: state.precision !== 'double',
        chosen: chosen && chosen.row,
      });
      if (!last) return;
      table.replaceChildren(resultTable(state, found, chosen && chosen.row));
      if (chosen) said({ quantity: 'choice', ...chosen.row });
    }

    function finish(found) {
      const lines = answer(state, found);
      result.replaceChildren(
        element('p', { class: 'finding' }, lines[0]),
        ...lines
          .slice(1)
          .filter(Boolean)
          .map((line) => element('p', {}, line)),
      );
      truth.textContent = truthText(state, found.truth);
      draw(found, true);
    }

    function start() {
      const mine = ++running;
      code.textContent = command(state);
      copy.textContent = 'copy';
      truth.textContent = '';
      if (!engine) return;
      if (!engine.scene(state.scene.number))
        return say('This scene is not in the page; the command below answers.');
      if (state.horizon * state.fps > mostFrames)
        return say(
          `This page judges at most ${count(mostFrames)} frames, and this is ${count(Math.round(state.horizon * state.fps))}; the command below judges up to a million.`,
        );
      const found = { rows: [], tried: 0, all: 0, truth: null, done: false };
      const steps = search(state, engine, found);
      let shown = performance.now();
      say('Trying …');
      (function slice() {
        if (mine !== running) return;
        const until = performance.now() + 12;
        try {
          while (performance.now() < until)
            if (steps.next().done) {
              if (found.truth) finish(found);
              else
                say(
                  'No run here comes to its end, so that nothing can be judged; the command below judges by references.',
                );
              return;
            }
        } catch (error) {
          return say('The run failed: ' + error.message);
        }
        if (found.rows.length && performance.now() - shown > 500) {
          shown = performance.now();
          result.firstChild.textContent = `Tried ${found.tried} of ${found.all} methods …`;
          draw(found, false);
        }
        setTimeout(slice, 0);
      })();
    }

    function say(text) {
      result.replaceChildren(element('p', {}, text));
      figure.replaceChildren();
      table.replaceChildren();
    }

    function begin() {
      try {
        state = fromHash(location.hash, scenes);
        message.textContent = '';
      } catch (error) {
        state = usual(first(scenes));
        message.textContent =
          'This link asks for what is not there: ' +
          error.message +
          '. Scene ' +
          state.scene.number +
          ' is shown as it is in the book.';
      }
      build();
      start();
    }

    if (!scenes.length) {
      message.textContent = "The scenes' data are missing.";
      return;
    }
    begin();
    addEventListener('hashchange', begin);
    const ready = oddity.engine ? oddity.engine.ready : Promise.resolve(false);
    ready.then((runs) => {
      if (!runs)
        return say(
          'This page was written without the compiled models, so that it cannot try anything; the command below answers.',
        );
      engine = oddity.engine;
      build();
      start();
    });
  }

  // Called by data/scenes.js.
  oddity.scenes = async (packed) => {
    oddity.allScenes = await oddity.unpacked(packed);
    oddity.charts.whenReady(() => document.querySelectorAll('div.chooser').forEach(chooser));
  };
  oddity.chooser = chooser;
  oddity.choosing = {
    asked,
    usual,
    fromHash,
    toHash,
    command,
    settings,
    errorsOf,
    inNeeds,
    pick,
    search,
    answer,
    quantityOf,
    frameTimes,
  };
})((window.oddity = window.oddity || {}));
