// The player of a scene: the truth as a ghost, up to four methods, their errors and their conserved
// quantities.

(function (oddity) {
  'use strict';

  const most = 4;
  const { make, sentence } = oddity;

  const worded = (text, title, click) => make('button', { type: 'button', title, click }, text);

  /** The words of a command, in quotes where a shell needs them. */
  const quoted = (text) => (/^[\w.,:=/+-]+$/.test(text) ? text : `'${text.replace(/'/g, `'\\''`)}'`);

  oddity.commands = function ({ number, parameters, changed, close, horizon, frame }) {
    const values = parameters.filter((p) => p.name in changed).map((p) => `${p.name}=${changed[p.name]}`);
    const errors = Object.entries(close).map(([unit, x]) =>
      (oddity.nameOfNeed(unit, x) === '1 cm' ? '1cm' : oddity.nameOfNeed(unit, x) === '1\u00b0' ? '1deg' : String(x)));
    const of = [number, ...values].map(quoted).join(' ');
    return {
      solve: `${oddity.program} solve ${of}`,
      choose: `${oddity.program} choose ${of} --error ${errors.join(',')} --horizon ${horizon} --fps ${Math.round(1 / frame)}`,
    };
  };

  /** Names that a link to a player may use for these motions. */
  oddity.nameable = (motions, parameters) => ({ parameters: motions.recordedOnly ? [] : parameters, methods: motions.methods,
    horizon: motions.scene.horizon, speeds: oddity.speeds, units: motions.data.units, space: motions.space });

  class Player {
    constructor(element, motions, begin = null) {
      this.element = element;
      this.motions = motions;
      this.scene = this.motions.scene;
      this.rows = [];
      this.clock = oddity.clock({ scene: this.scene, frame: this.motions.frame, show: () => this.paint() });
      this.build();
      this.picture = oddity.picture(this.canvas, this.motions);
      this.look();
      this.restart(begin || this.fromLink() || this.usual());
      this.follow();
    }

    // ---- state --------------------------------------------------------------------------------------------

    usual() {
      return { parameters: {}, rows: this.motions.opening(), time: 0, speed: 1 };
    }

    /** Names that a link may use. */
    known() {
      return { ...oddity.nameable(this.motions, this.sliding()),
        missing: this.motions.recordedOnly ? 'is not recorded, and the models are not in this copy of the page' : 'this scene does not have' };
    }

    fromLink() {
      const read = oddity.permalink.parse(window.location.hash, this.known());
      if (!read) return null;
      requestAnimationFrame(() => this.element.scrollIntoView({ block: 'start' }));
      if (read.problem) {
        this.say(`${read.problem} This is the player as it opens.`, true);
        return null;
      }
      const { state } = read;
      if (state.time > 0) this.clock.wanted = false;
      return state.rows.length ? state : { ...state, rows: this.motions.opening() };
    }

    restart({ parameters, rows, time, speed, view = null, as = oddity.framesAs[0] }) {
      this.as = as;
      this.framesChoice.value = as.name;
      this.picture.look(view);
      this.parameters = { ...this.motions.defaults, ...parameters };
      this.clock.setSpeed(speed);
      this.rows = [];
      this.rowsPlace.replaceChildren();
      rows.slice(0, most).forEach((row) => this.addRow(row));
      for (const [name, slider] of this.sliders) slider.show(this.parameters[name]);
      this.compute();
      this.clock.seek(time);
    }

    addRow(method) {
      const taken = this.rows.map((r) => r.shape);
      const shape = [0, 1, 2, 3].find((s) => !taken.includes(s));
      const row = { shape, method: { trial: null, ...method } };
      row.view = oddity.methodRow({
        motions: this.motions, row: row.method, shape,
        changed: (next) => this.change(row, next),
        removed: () => this.removeRow(row),
        refused: (text) => this.refuse(text),
      });
      row.view.element.style.setProperty('--method', `var(--series-${shape + 1})`);
      row.view.paint(this.colours[shape]);
      this.rows.push(row);
      this.rowsPlace.append(row.view.element);
      return row;
    }

    removeRow(row) {
      const place = this.rows.indexOf(row);
      this.rows.splice(place, 1);
      row.view.element.remove();
      this.say(`${sentence(row.method.algorithm)} on ${row.method.model} is removed.`);
      const next = this.rows[Math.min(place, this.rows.length - 1)];
      (next ? next.view : { focus: () => this.addButton.focus() }).focus();
      this.compute();
    }

    /** Called when a row's method or setting is changed by hand. */
    change(row, next) {
      const other = ['model', 'algorithm', 'precision'].some((name) => row.method[name] !== next[name]);
      row.method = next;
      this.later(() => {
        this.point(next);
        if (other) this.ended();
        this.showRow(row);
      });
    }

    showRow({ method, result }) {
      if (!result.motion) return;
      clearTimeout(this.saying);
      this.saying = setTimeout(() =>
        this.say(`${sentence(method.algorithm)} on ${method.model}: ${oddity.seen(this.motions, this.parameters, method)}`, false, true), 400);
    }

    /** At the end, playing restarts from the beginning. */
    ended() {
      if (this.clock.time >= this.scene.horizon) this.clock.seek(0);
    }

    /** Shows a method in charts, tables and maps; `parameters` only if they are not the book's. */
    point({ model, algorithm, precision, setting }) {
      const detail = { quantity: this.motions.quantity.name, model, algorithm, precision, setting };
      const { parameters } = this.state();
      if (Object.keys(parameters).length) detail.parameters = this.parameters;
      document.dispatchEvent(new CustomEvent('oddity:point', { detail }));
    }

    // ---- computing ----------------------------------------------------------------------------------------

    /** Computes once a frame, however often a slider reports. */
    later(then = () => {}) {
      this.then = [...(this.then || []), then];
      if (this.pending) return;
      this.pending = requestAnimationFrame(() => {
        this.pending = 0;
        const all = this.then;
        this.then = [];
        this.compute();
        all.forEach((f) => f());
      });
    }

    compute() {
      this.element.classList.remove('stale');
      const { motions, scene, parameters } = this;
      const started = performance.now();
      this.truth = motions.truth(parameters);
      const units = Object.keys(scene.close);
      const sizes = oddity.sizes(this.truth, scene.norms, units);
      const floors = motions.floors(parameters, sizes);
      for (const row of this.rows) {
        const motion = motions.run(parameters, row.method, this.as);
        row.result = { row: row.method, motion, judged: motion && motions.judge(motion, parameters),
          floors: motions.floorsOf(motion, floors) };
        row.view.show(row.result);
      }
      this.picture.show(parameters, this.truth, this.ghostColour, this.shown().map((row) =>
        ({ motion: row.result.motion, colour: this.colours[row.shape] })));
      this.plot(sizes, floors);
      this.portray();
      this.showTruth();
      this.offerRows();
      this.element.dataset.computed = (performance.now() - started).toFixed(1);
      this.paint();
    }

    /** The rows with a motion. */
    shown() { return this.rows.filter((row) => row.result.motion); }

    plot(sizes, floors) {
      const { scene } = this;
      const units = Object.keys(scene.close);
      const one = units.length === 1;
      const shown = this.shown();
      const common = { end: scene.horizon, ticks: this.ticks(), timeUnit: scene.time_unit };
      this.errorName.textContent = one ? `error${units[0] && ` [${units[0]}]`}` : `error, in parts of ${oddity.needName(scene.close)}`;
      this.errorLines.set({ ...common, need: one ? scene.close[units[0]] : 1, needName: oddity.needName(scene.close),
        floor: one ? floors[0] : Math.max(...floors.map((x, u) => x / scene.close[units[u]])),
        ceiling: 1e4 * Math.max(...sizes.map((x, u) => (one ? x : x / scene.close[units[u]]))),
        series: shown.map((r) => ({ times: r.result.motion.times, shape: r.shape, colour: this.colours[r.shape],
          values: one ? r.result.judged.errors[0] : r.result.judged.needs })) });
      const conserving = shown.filter((r) => r.result.motion.drift.length);
      this.driftFigure.hidden = !conserving.length;
      this.driftLines.set({ ...common, need: 0, floor: 1e-16, ceiling: 1e4,
        series: conserving.map((r) => ({ times: r.result.motion.times, values: r.result.motion.drift, shape: r.shape,
          colour: this.colours[r.shape] })) });
    }

    ticks() {
      const { horizon } = this.scene;
      const every = [0.25, 0.5, 1, 2, 2.5, 5].find((x) => horizon / x <= 6) || horizon / 4;
      const all = [];
      for (let t = 0; t < horizon - 0.4 * every; t += every) all.push(t);
      return [...all, horizon];
    }

    /** Describes the ghost, and the difference of the two methods that compute it. */
    showTruth() {
      const { motions } = this;
      if (motions.aboutTruth) return this.tell(motions.aboutTruth(this.parameters));
      const { richest } = motions;
      if (this.truth === motions.reference && !richest) return this.tell('The ghost is the true motion: the reference, kept to seven digits.');
      const { resolution } = motions.find(richest.model, richest.algorithm);
      const by = `${richest.algorithm} on ${richest.model}` + (resolution ? ` at a ${resolution} of ${oddity.written(richest.setting)}` : '');
      const apart = oddity.amounts(motions.apart(), Object.keys(this.scene.close));
      if (this.truth === motions.reference)
        this.tell(`The ghost is the true motion: the reference, kept to seven digits. With other parameters it is ${by}, which here is ${apart} from it at most.`);
      else if (this.truth.ending !== 'reached')
        this.tell(`With these parameters the true motion is not known to the end: ${this.truth.message}.`);
      else
        this.tell(`The ghost is ${by}. At the book\u2019s parameters that is ${apart} from the true motion at most.`);
    }

    tell(text) {
      this.truthNote.textContent = text;
    }

    // ---- the page -----------------------------------------------------------------------------------------

    build() {
      const { data } = this.motions;
      this.element.setAttribute('role', 'group');
      this.element.setAttribute('aria-label', `Player: ${data.title}`);
      this.element.replaceChildren(
        make('div', { class: 'player-figure' }, this.buildStage(), this.buildCurves()),
        this.clock.element,
        this.buildPortraits(),
        this.truthNote = make('p', { class: 'player-truth' }),
        this.rowsPlace = make('div', { class: 'player-rows' }),
        this.buildFrames(),
        this.buildActions(),
        this.said = make('p', { class: 'player-says', role: 'status', 'aria-live': 'polite' }),
        this.buildParameters());
      this.element.addEventListener('keydown', (event) => this.key(event));
    }

    buildStage() {
      this.canvas = make('canvas', { class: 'player-canvas', role: 'img', tabindex: 0, 'aria-label': this.scenePicture() });
      this.clockText = make('span', { class: 'player-clock' });
      return make('div', { class: 'player-stage' }, this.canvas, this.clockText);
    }

    scenePicture() {
      return `${this.motions.data.title}: the true motion as a ghost, and each method in its colour.`
        + (this.motions.space ? ' Drag or arrow keys turn it.' : '');
    }

    buildCurves() {
      const chart = (label) => make('canvas', { class: 'player-lines', role: 'img', 'aria-label': label });
      const error = this.errorCanvas = chart('Error of each method over time; the rows below have the numbers.');
      const drift = chart('Change of conserved quantities over time; the rows below have the numbers.');
      this.errorLines = oddity.lines(error);
      this.driftLines = oddity.lines(drift);
      this.errorName = make('figcaption', {});
      this.driftFigure = make('figure', {}, make('figcaption', {}, 'relative change of energy and other conserved quantities'), drift);
      return make('div', { class: 'player-curves' }, make('figure', {}, this.errorName, error), this.driftFigure);
    }

    /** Phase portraits: the first two observables, each against its rate, if the scene has at most three. */
    buildPortraits() {
      const names = this.scene.observables.length <= 3 ? this.scene.observables.slice(0, 2) : [];
      const canvases = names.map((name) => make('canvas', { class: 'player-lines', role: 'img', 'aria-label': `${name} against its rate: the true motion, and each method up to now.` }));
      this.portraits = canvases.map((canvas) => oddity.portrait(canvas));
      this.portraitPlace = make('details', { class: 'player-more' }, make('summary', {}, `phase portrait: ${names.join(', ')} against ${names.length > 1 ? 'their rates' : 'its rate'}`),
        make('div', { class: 'player-portraits' }, ...canvases));
      this.portraitPlace.hidden = !names.length;
      this.portraitPlace.addEventListener('toggle', () => { this.portray(); this.portraits.forEach((one) => one.resize()); });
      return this.portraitPlace;
    }

    portray() {
      if (!this.portraitPlace.open) return;
      const { horizon, observables } = this.scene;
      const all = [{ see: this.motions.seeTruth, motion: this.truth, colour: this.ghostColour, ghost: true },
        ...this.shown().map((r) => ({ see: oddity.between, motion: r.result.motion, colour: this.colours[r.shape], shape: r.shape }))];
      this.portraits.forEach((portrait, nth) => portrait.set({ name: observables[nth],
        series: all.map(({ see, motion, ...rest }) => ({ ...rest, phases: oddity.phases(see, motion, horizon, nth) })) }));
    }

    buildActions() {
      const { motions } = this;
      this.addButton = worded('add a method', 'one more method, up to four', () => this.add());
      const published = motions.asPublished();
      const doing = [this.addButton];
      if (published) doing.push(worded('as published', 'the published version next to the right one',
        () => this.preset(published, 'The published version is next to the right one')));
      const engines = motions.asEngines();
      if (engines) doing.push(worded('as engines do', 'physics engines as a user gets them, at a step a frame, next to a method that is enough',
        () => this.preset(engines, 'Recorded: physics engines as a user gets them, at a step a frame')));
      doing.push(worded('as it opened', 'parameters and methods as the page has them first', () => this.preset(motions.opening(), 'As it opened')));
      if (!motions.recordedOnly) doing.push(worded('break it', 'the smallest step with which the first method breaks', () => this.breakIt()));
      const copying = [worded('copy link', 'an address that opens the player as it is now', () => this.link())];
      for (const verb of motions.data.example || motions.data.file ? [] : ['solve', 'choose'])
        copying.push(worded(`copy oddity ${verb}`, verb === 'solve' ? 'the command that runs every method at these parameters'
          : 'the command that chooses a method for these parameters', () => this.command(verb)));
      return make('div', { class: 'player-actions' }, make('div', {}, ...doing), make('div', {}, ...copying));
    }

    /** How frames come, each of which is the methods' steps. */
    buildFrames() {
      this.framesChoice = make('select', { change: () => this.setFrames(this.framesChoice.value) },
        ...oddity.framesAs.map(({ name, says }) => make('option', { value: name }, says)));
      return make('p', { class: 'player-frames', hidden: this.motions.recordedOnly },
        make('label', {}, 'frames, as they come: ', this.framesChoice));
    }

    setFrames(name) {
      this.as = oddity.framesAs.find((as) => as.name === name);
      this.later(() => {
        this.ended();
        if (this.rows.length) this.showRow(this.rows[0]);
      });
    }

    /** The parameters with a part in the motion: seeds are of random samples. */
    sliding() {
      const { varied } = this.scene;
      const all = this.motions.data.parameters.filter((p) => p.name !== 'seed');
      return [...all.filter((p) => p.name === varied), ...all.filter((p) => p.name !== varied)];
    }

    buildParameters() {
      this.sliders = new Map(this.sliding().map((p) => [p.name, oddity.slider({ name: p.name, says: p.says,
        unit: p.unit, units: this.motions.data.units[p.unit], scale: oddity.scaleOf(p), value: p.value,
        checked: (x) => this.problemOf(p, x), changed: (x) => this.setParameter(p, x), refused: (text) => this.refuse(text) })]));
      const all = [...this.sliders.values()].map((s) => s.element);
      const grid = (some) => make('div', { class: 'player-parameters' }, ...some);
      const shown = all.length > 9 ? 6 : all.length;
      const place = make('div', {}, grid(all.slice(0, shown)));
      if (shown < all.length)
        place.append(make('details', { class: 'player-more' },
          make('summary', {}, `${all.length - shown} more parameters`), grid(all.slice(shown))));
      if (this.motions.recordedOnly) this.showRecorded(place);
      return place;
    }

    showRecorded(place) {
      for (const slider of this.sliders.values()) slider.enable(false);
      place.prepend(make('p', { class: 'player-note' },
        'The models are not in this copy of the page, so it plays recordings. ', make('code', {}, `${oddity.program} site`),
        ' makes a copy that runs them.'));
    }

    /** The display does not match the typed text. */
    refuse(text) {
      this.element.classList.add('stale');
      this.say(text, true);
    }

    problemOf(p, x) {
      if (p.whole && !Number.isInteger(x)) return `${p.name} has to be a whole number.`;
      if ((Number.isFinite(p.least) && x < p.least) || (Number.isFinite(p.most) && x > p.most))
        return `${p.name} goes from ${oddity.inField(p.least)} to ${oddity.inField(p.most)} ${oddity.unitName(p.unit)}.`;
      return '';
    }

    setParameter(p, value) {
      this.parameters = { ...this.parameters, [p.name]: value };
      this.rows.forEach((row) => { row.method = { ...row.method, trial: null }; });
      this.sliders.get(p.name).show(value);
      this.later(() => {
        this.ended();
        if (this.rows.length) this.showRow(this.rows[0]);
      });
    }

    offerRows() {
      this.addButton.disabled = this.rows.length >= most;
    }

    /** Also announced by a screen reader; `unseen` is only for it, as the page shows the text elsewhere. */
    say(text, problem = false, unseen = false) {
      clearTimeout(this.saying);
      this.said.textContent = text;
      this.said.classList.toggle('player-problem', problem);
      this.said.classList.toggle('unseen', unseen);
    }

    // ---- actions ------------------------------------------------------------------------------------------

    add() {
      if (this.rows.length >= most) return;
      const has = (m) => this.rows.some((r) => r.method.model === m.model && r.method.algorithm === m.algorithm);
      const { motions } = this;
      const next = [...motions.opening(), ...['Runge-Kutta 4', 'velocity Verlet', 'closed form'].flatMap((name) =>
        motions.methods.filter((m) => m.algorithm === name)), ...motions.methods].find((m) => !has(m)) || motions.methods[0];
      const method = motions.find(next.model, next.algorithm);
      const row = this.addRow({ model: method.model, algorithm: method.algorithm, precision: method.precisions[0],
        setting: next.setting === undefined ? motions.usual(method) : next.setting });
      this.compute();
      this.point(row.method);
      row.view.focus();
      this.showRow(row);
    }

    preset(rows, text) {
      this.restart({ parameters: {}, rows, time: 0, speed: this.clock.speed, view: this.picture.view() });
      this.say(`${text}, from the start.`);
      this.clock.play();
    }

    breakIt() {
      const found = oddity.breaking(this.motions, this.parameters, this.rows.map((r) => r.method));
      if (found.problem) return this.say(found.problem);
      const row = this.rows.find((r) => r.method === found.was);
      row.method = { ...found.row, trial: null };
      this.compute();
      this.clock.seek(0);
      this.point(row.method);
      this.say(found.text);
      this.clock.play();
    }

    state() {
      const { defaults } = this.motions;
      const changed = Object.fromEntries(Object.entries(this.parameters).filter(([name, x]) => x !== defaults[name]));
      return { parameters: changed, rows: this.rows.map((r) => r.method), time: this.clock.time, speed: this.clock.speed,
        view: this.picture.view(), as: this.as };
    }

    async copy(text, done) {
      try {
        await navigator.clipboard.writeText(text);
        this.say(`${done}: ${text}`);
      } catch (error) {
        this.say(text);
      }
    }

    link() {
      window.location.hash = oddity.permalink.format(this.state());
      this.linked = window.location.hash;
      this.copy(window.location.href, 'Copied');
    }

    command(verb) {
      const { data, frame } = this.motions;
      const all = oddity.commands({ number: data.number, parameters: data.parameters, changed: this.state().parameters,
        close: this.scene.close, horizon: this.scene.horizon, frame });
      this.copy(all[verb], 'Copied');
    }

    /** Adds a trial of a chart or a map, at the book's parameters except the given ones. */
    trial({ quantity, model, algorithm: named, precision = 'double', setting, parameters = {} }) {
      const { motions } = this;
      if (quantity && quantity !== motions.quantity.name) return;
      const algorithm = String(named).replace(/ in float$/, '');
      const method = motions.find(model, algorithm);
      this.element.scrollIntoView({ behavior: oddity.calm() ? 'auto' : 'smooth', block: 'nearest' });
      if (!method || !method.precisions.includes(precision))
        return this.say(`${sentence(algorithm)} on ${model}${precision === 'float' ? ' in float' : ''} does not run in the page.`, true);
      if (method.path && method.path.setting !== setting)
        this.say(`${sentence(algorithm)} on ${model} is recorded at ${oddity.written(method.path.setting)} only, which is what is shown.`);
      this.parameters = { ...motions.defaults };
      for (const p of this.sliding())
        if (Number.isFinite(parameters[p.name]) && !this.problemOf(p, parameters[p.name])) this.parameters[p.name] = parameters[p.name];
      for (const [name, slider] of this.sliders) slider.show(this.parameters[name]);
      const next = { model, algorithm, precision, setting: method.path ? method.path.setting : setting,
        trial: motions.isDefault(this.parameters) ? this.tabled(method, precision, method.path ? method.path.setting : setting) : null };
      const same = this.rows.find((r) => ['model', 'algorithm', 'precision'].every((k) => r.method[k] === next[k]));
      if (same) same.method = next;
      else {
        if (this.rows.length >= most) this.rows.pop().view.element.remove();
        this.addRow(next);
      }
      this.compute();
      this.clock.seek(0);
      this.clock.play();
    }

    /** The trial's entry in the table. */
    tabled({ model, algorithm, path }, precision, setting) {
      const found = this.motions.quantity.methods.find((m) => m.model === model && m.precision === precision
        && m.algorithm.replace(/ in float$/, '') === algorithm);
      const trial = found && found.trials.find((t) => t[0] === setting);
      if (!trial) return null;
      const units = Object.keys(this.scene.close);
      const unit = units.length === 1 ? ` ${units[0]}` : '';
      const error = trial[1] === null ? 'no error' : `an error of ${oddity.written(trial[1])}${unit}`;
      const stops = found.resolution === 'tolerance' && !path ? '; here it stops at every frame' : '';
      return `The table has ${error} at its ${this.motions.looks} times, ${oddity.outcomeName(this.motions.data, trial[5])}${stops}.`;
    }

    /** Space plays, arrows step through frames; where arrows have another use, Shift and arrows do. */
    key(event) {
      const { target, key, shiftKey } = event;
      if (target.matches('input[type=text], select') || event.ctrlKey || event.metaKey || event.altKey) return;
      const step = { ArrowLeft: -1, ArrowRight: 1 }[key];
      if (key === ' ' && !target.matches('button, summary')) this.clock.toggle();
      else if (step && (shiftKey || !target.matches('input'))) this.clock.step(step);
      else return;
      event.preventDefault();
    }

    // ---- painting -----------------------------------------------------------------------------------------

    paint() {
      const { time } = this.clock;
      this.clockText.textContent = `t = ${this.clock.text()}`;
      for (const row of this.rows) row.view.now(time);
      this.picture.paint(time);
      this.paintCurves(time);
    }

    paintCurves(time) {
      this.errorLines.paint(time);
      this.driftLines.paint(time);
      if (this.portraitPlace.open) this.portraits.forEach((one) => one.paint(time));
    }

    /** Updates sizes and colours from the page. */
    look() {
      this.picture.resize();
      const style = getComputedStyle(this.element);
      const colour = (name, other) => style.getPropertyValue(name).trim() || other;
      this.colours = ['#0072b2', '#c95600', '#00805e', '#a8437f'].map((other, i) => colour(`--series-${i + 1}`, other));
      this.ghostColour = colour('--ghost', '#9d968a');
      this.rows.forEach((row) => row.view.paint(this.colours[row.shape]));
      this.errorLines.resize();
      this.driftLines.resize();
      if (this.portraitPlace.open) this.portraits.forEach((one) => one.resize());
    }

    /** Follows changes outside: sizes and colours, links, trials of charts, and visibility. */
    follow() {
      this.ending = new AbortController();
      const { signal } = this.ending;
      const again = () => {
        this.look();
        this.compute();
      };
      this.sizes = new ResizeObserver(again);
      [this.canvas, this.errorCanvas].forEach((canvas) => this.sizes.observe(canvas));
      window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', again, { signal });
      window.addEventListener('hashchange', () => this.goTo(), { signal });
      window.addEventListener('beforeprint', () => this.paintCurves(this.clock.horizon), { signal });
      window.addEventListener('afterprint', () => this.paint(), { signal });
      document.addEventListener('oddity:play', (event) => this.trial(event.detail || {}), { signal });
      this.sight = new IntersectionObserver((entries) => this.clock.seen(entries[entries.length - 1].isIntersecting), { threshold: 0.3 });
      this.sight.observe(this.canvas);
    }

    /** Goes to the state in the address. */
    goTo() {
      if (window.location.hash === this.linked || !window.location.hash.startsWith('#play&')) return;
      this.clock.pause();
      const state = this.fromLink();
      this.restart(state || this.usual());
      if (state) this.say('The player is set as in the link.');
    }

    /** Ends this player before another replaces it. */
    end() {
      this.clock.pause();
      clearTimeout(this.saying);
      cancelAnimationFrame(this.pending);
      this.ending.abort();
      this.sizes.disconnect();
      this.sight.disconnect();
    }
  }

  oddity.Player = Player;

  oddity.player = async function (element) {
    const running = oddity.engine && (await oddity.engine.ready);
    return new Player(element, oddity.motions(oddity.data, running ? oddity.engine : null));
  };

  if (typeof document !== 'undefined')
    document.addEventListener('DOMContentLoaded', () => oddity.with_data(({ scene }) => {
      if (scene) document.querySelectorAll('.player').forEach((element) => { oddity.player(element); });
    }));
})(window.oddity = window.oddity || {});
