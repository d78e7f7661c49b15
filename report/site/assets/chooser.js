// The chooser: which model, algorithm and step are enough for a game, computed in the page. Its request is in
// asking.js, its search in searching.js and its answer in advice.js.
(function (oddity) {
  'use strict';

  const { number, count, duration, element, chart, said } = oddity.charts;
  const {
    asked,
    unitsOf,
    usual,
    setParameter,
    setPositive,
    setBudget,
    setPrecision,
    first,
    fromHash,
    errorText,
    toHash,
    command,
    search,
    pick,
    settingOf,
    errorIn,
    answer,
    truthText,
  } = oddity.choosing;

  const mostFrames = 36000;
  const outcomes = {
    o: 'holds',
    i: 'inaccurate',
    N: 'non-finite',
    S: 'stalled',
    C: 'chattering',
    G: 'grazing',
    R: 'raised',
  };

  const measure = '. The answer above goes by the time in this page, this chart by the quantity on its axis';

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
          resolution: row.resolution,
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
        ? 'error over all frames, judged by the finest run' + measure
        : 'error over all frames relative to the allowed one, judged by the finest run' + measure,
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
        place.classList.remove('stale');
        history.replaceState(null, '', toHash(state));
        start();
      } catch (error) {
        ++running;
        place.classList.add('stale');
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

    /** The axis chosen above the chart is kept for the next one. */
    function lookAtAxis() {
      const pressed = figure.querySelector('.choice [aria-pressed=true]');
      if (pressed) axis = pressed.textContent === 'time' ? 'time' : 'evaluations';
    }

    function draw(found, last) {
      const chosen = last ? pick(found.rows, state.budget ? state.budget.value : null) : null;
      const quantity = quantityOf(state, found);
      lookAtAxis();
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
      lookAtAxis();
      result.replaceChildren(element('p', {}, text));
      figure.replaceChildren();
      table.replaceChildren();
    }

    function begin(hash = location.hash) {
      try {
        state = fromHash(hash, scenes);
        message.textContent = '';
      } catch (error) {
        state = usual(first(scenes));
        message.textContent =
          'This link does not work: ' +
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
    /** False if a link leads to a place in the page. */
    const asked = () => !document.getElementById(location.hash.slice(1));
    begin(asked() ? location.hash : '');
    addEventListener('hashchange', () => asked() && begin());
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
  Object.assign(oddity.choosing, { quantityOf });
})((window.oddity = window.oddity || {}));
