// The lesson: a mass on a spring by the compiled models, explained step by step.
(function (oddity) {
  'use strict';

  const scene = '0.2', model = 'spring', circle = ['circle', 'closed form'];
  const end = 20;                // s
  const slowly = 2;              // s, for a motion that is shown only in part
  const reach = 2.1;             // m, of the charts and the stage
  const farthest = 1.5;          // m, at the start
  const least = 0.05;            // m, so that there is a motion
  const patience = 0.1;          // s, the longest that a frame may count
  const { make, written } = oddity;

  const energyOf = (w, x, v) => (v * v + w * w * x * x) / 2;
  /** The quantity that a method conserves instead of the energy, at the step h. */
  const kept = {
    'symplectic Euler': (h, w, x, v) => energyOf(w, x, v) - h * w * w * x * v / 2,
    'velocity Verlet': (h, w, x, v) => (v * v / (1 - h * h * w * w / 4) + w * w * x * x) / 2,
  };

  class Lesson {
    constructor(element) {
      this.element = element;
      this.steps = [...element.querySelectorAll('.told > li')];
      this.given = { w: oddity.engine.scene(scene).defaults.w, x0: 1, v0: 0 };
      this.time = 0;
      this.playing = false;
      this.build();
      this.go(Math.max(0, this.steps.findIndex((step) => `#${step.dataset.name}` === window.location.hash)));
      this.follow();
    }

    // ---- computation --------------------------------------------------------------------------------------

    run(times, [asked, algorithm], setting) {
      const { observed } = oddity.engine.run({ scene, parameters: this.given, model: asked, algorithm, precision: 'double', setting, times });
      return { x: observed.filter((_, i) => i % 2 === 0), v: observed.filter((_, i) => i % 2 === 1) };
    }

    compute() {
      const { h, given: { w } } = this;
      const count = this.shown || Math.ceil(end / h);
      this.end = count * h;
      this.times = Float64Array.from({ length: count + 1 }, (_, k) => k * h);
      this.motion = this.run(this.times, this.algorithm === circle[1] ? circle : [model, this.algorithm], h);
      const frames = Math.round(60 * Math.min(this.end, end)) + 1;
      this.truth = this.run(Float64Array.from({ length: frames + 1 }, (_, i) => i / 60), circle, 0).x;
      const of = (f) => Array.from(this.motion.x, (x, k) => f(x, this.motion.v[k]));
      this.energies = of((x, v) => energyOf(w, x, v));
      const keeps = kept[this.algorithm];
      this.shadows = keeps && h * w < 2 ? of((x, v) => keeps(h, w, x, v)) : null;
      this.circlePlot.show({ radius: Math.sqrt(2 * this.energies[0]) / w, way: of((x, v) => [x, v / w]), dotted: this.algorithm !== circle[1] });
      this.energyPlot.show({ end: this.end, energies: this.energies, shadows: this.shadows, times: this.times });
      this.tell();
    }

    tell() {
      const { h, energies, shadows, given: { w } } = this;
      const parts = energies.map((e) => e / energies[0]).filter(Number.isFinite);
      const leastPart = Math.min(...parts), most = Math.max(...parts), last = parts[parts.length - 1];
      const text = [`h\u03c9 = ${written(h * w)}`];
      if (this.algorithm === circle[1]) text[0] = 'the energy stays';
      else if (shadows) {
        const off = Math.max(...shadows.map((s) => Math.abs(s / shadows[0] - 1)));
        text.push(`energy \u00d7 ${written(leastPart)} to ${written(most)}`, off < 1e-9 ? 'shadow energy kept' : `shadow energy off by ${written(off)}`);
        this.element.dataset.shadow = off;
      } else {
        text.push(`each step \u00d7 ${written(parts[1], 4)}`);
        if (!this.shown) text.push(`after ${written(this.end)} s \u00d7 ${written(last)}`);
        this.element.dataset.factor = parts[1];
      }
      this.readings.textContent = text.join(' \u00b7 ');
    }

    // ---- text ---------------------------------------------------------------------------------------------

    go(to) {
      if (to < 0 || to >= this.steps.length) return;
      this.at = to;
      const { algorithm, step, shown } = this.steps[to].dataset;
      this.steps.forEach((other, i) => other.classList.toggle('now', i === to));
      this.algorithm = algorithm;
      this.shown = Number(shown);
      this.h = Number(step);
      this.sliders.h.show(this.h);
      this.sliders.h.enable(algorithm !== circle[1]);
      this.back.disabled = to === 0;
      this.next.disabled = to === this.steps.length - 1;
      this.place.textContent = `${to + 1} of ${this.steps.length}`;
      window.history.replaceState(null, '', `#${this.steps[to].dataset.name}`);
      this.again();
    }

    /** Restarts from the present initial condition. */
    again() {
      this.compute();
      this.seek(oddity.calm() ? this.end : 0);
      if (!oddity.calm()) this.play();
    }

    set(name, value) {
      if (name === 'h') this.h = value;
      else this.given[name] = value;
      this.sliders[name].show(value);
      this.again();
    }

    /** Starts from the place to which the mass is dragged. */
    hold(x, v) {
      const size = Math.hypot(x, v / this.given.w);
      const scale = Math.min(1, farthest / size);
      this.given.x0 = size < least ? least : x * scale;
      this.given.v0 = v * scale;
      this.sliders.x0.show(this.given.x0);
      this.pause();
      this.compute();
      this.seek(0);
    }

    // ---- time ---------------------------------------------------------------------------------------------

    play() {
      if (this.playing) return;
      if (this.time >= this.end) this.seek(0);
      this.playing = true;
      this.playButton.textContent = 'Pause';
      let before = performance.now();
      const frame = (now) => {
        if (!this.playing) return;
        const passed = Math.min(patience, Math.max(0, now - before) / 1000);
        before = now;
        this.seek(this.time + passed * (this.shown ? this.end / slowly : 1));
        if (this.time >= this.end) this.pause();
        else requestAnimationFrame(frame);
      };
      requestAnimationFrame(frame);
    }

    pause() {
      this.playing = false;
      this.playButton.textContent = 'Play';
    }

    seek(t) {
      this.time = Math.min(this.end, t);
      const { motion: { x, v }, given: { w }, h, times } = this;
      const steps = Math.min(times.length - 1, Math.floor(this.time / h + 1e-9));
      const next = Math.min(times.length - 1, steps + 1), part = this.time / h - steps;
      const between = (values) => (next > steps ? values[steps] + part * (values[next] - values[steps]) : values[steps]);
      const place = [between(x), between(v)];
      this.circlePlot.now(steps, [place[0], place[1] / w]);
      this.energyPlot.now(steps);
      const frame = Math.min(this.truth.length - 1, Math.round(60 * this.time));
      const draw = (at) => oddity.engine.draw(scene, this.given, this.time, [at, 0]);
      this.stage.paint([{ drawing: draw(this.truth[frame]), colour: this.colours.ghost, ghost: true, trails: [] },
        { drawing: draw(Math.max(-50, Math.min(50, place[0]))), colour: this.colours.way, ghost: false, trails: [] }]);
    }

    // ---- the page -----------------------------------------------------------------------------------------

    build() {
      const button = (text, title, click) => make('button', { type: 'button', title, click }, text);
      this.circlePlot = oddity.circlePlot(reach);
      this.energyPlot = oddity.energyPlot();
      this.canvas = make('canvas', { role: 'img', 'aria-label': 'The mass on its spring, and the true one as a ghost. Drag the mass.' });
      this.back = button('\u2190 Back', 'arrow left', () => this.go(this.at - 1));
      this.next = button('Next \u2192', 'arrow right', () => this.go(this.at + 1));
      this.place = make('span', { class: 'lesson-place', 'aria-live': 'polite' });
      this.playButton = button('Play', 'space', () => (this.playing ? this.pause() : this.play()));
      this.readings = make('p', { class: 'lesson-readings' });
      const told = this.element.querySelector('.told');
      this.element.classList.add('live');
      this.element.append(
        make('div', { class: 'lesson-side' },
          make('div', { class: 'lesson-steps' }, this.back, this.place, this.next), told,
          make('div', { class: 'lesson-controls' }, ...this.buildSliders()),
          make('div', { class: 'lesson-actions' }, this.playButton,
            button('Full screen', 'f', () => this.fullScreen()), button('Print a handout', 'all steps on two pages', () => window.print()))),
        make('div', { class: 'lesson-figures' },
          make('div', { class: 'lesson-stage' }, this.canvas),
          make('figure', { class: 'lesson-circle' }, this.circlePlot.element),
          make('figure', { class: 'lesson-energy' }, this.energyPlot.element, this.readings)));
      this.stage = oddity.stage(this.canvas, { space: false });
      this.stage.fit([-reach, reach].map((x) => oddity.engine.draw(scene, {}, 0, [x, 0])));
      this.look();
    }

    buildSliders() {
      const slider = (name, letter, says, unit, from, to, value) => {
        this.sliders[name] = oddity.slider({ name: letter, says, unit, value, scale: oddity.scaleOf({ value, unit, least: from, most: to }),
          checked: (x) => (x >= from && x <= to && (name !== 'x0' || Math.abs(x) >= least) ? '' : `${says} goes from ${from} to ${to} ${unit}.`),
          changed: (x) => this.set(name, name === 'x0' && Math.abs(x) < least ? least : x),
          refused: (text) => { this.readings.textContent = text; } });
        return this.sliders[name].element;
      };
      this.sliders = {};
      return [slider('h', 'h', 'step', 's', 1 / 120, 2, 0.25), slider('w', 'omega', 'frequency', '1/s', 0.5, 8, this.given.w),
        slider('x0', 'x0', 'place at the start', 'm', -farthest, farthest, this.given.x0)];
    }

    look() {
      const style = getComputedStyle(this.element);
      this.colours = { ghost: style.getPropertyValue('--ghost').trim(), way: style.getPropertyValue('--series-2').trim() };
      this.stage.resize();
    }

    fullScreen() {
      if (document.fullscreenElement) document.exitFullscreen();
      else this.element.requestFullscreen();
    }

    key(event) {
      const { key, target } = event;
      if (event.ctrlKey || event.metaKey || event.altKey || target.matches('input') || document.querySelector('dialog[open]')) return;
      const step = { ArrowLeft: -1, PageUp: -1, ArrowRight: 1, PageDown: 1 }[key];
      if (step) this.go(this.at + step);
      else if (key === 'f') this.fullScreen();
      else if (key === ' ' && !target.matches('button, a, summary')) this.playButton.click();
      else return;
      event.preventDefault();
    }

    /** Calls `moved` for a pointer from its press on `on` to its release, and then plays. */
    drag(on, moved) {
      on.addEventListener('pointerdown', (event) => {
        on.setPointerCapture(event.pointerId);
        moved(event);
        on.addEventListener('pointermove', moved);
        on.addEventListener('pointerup', () => {
          on.removeEventListener('pointermove', moved);
          this.play();
        }, { once: true });
      });
    }

    follow() {
      this.drag(this.canvas, (event) => this.hold((event.clientX - this.canvas.getBoundingClientRect().left - this.stage.place.x) / this.stage.place.scale, 0));
      this.drag(this.circlePlot.element, (event) => {
        const [x, y] = this.circlePlot.placeOf(event);
        this.hold(x, y * this.given.w);
      });
      document.addEventListener('keydown', (event) => this.key(event));
      window.addEventListener('hashchange', () => this.go(this.steps.findIndex((step) => `#${step.dataset.name}` === window.location.hash)));
      const again = () => {
        this.look();
        this.seek(this.time);
      };
      new ResizeObserver(again).observe(this.canvas);
      window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', again);
    }
  }

  oddity.engine.ready.then((runs) => {
    const element = document.querySelector('.lesson');
    if (runs) oddity.lesson = new Lesson(element);
  });
})(window.oddity = window.oddity || {});
