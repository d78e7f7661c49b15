// A method as a row of a player: its settings and its result.

(function (oddity) {
  'use strict';

  const { written } = oddity;

  /** 0.12 rad; 0.003 m, 0.12 rad. */
  oddity.amounts = (values, units, digits = 2) => units.map((unit, u) => `${written(values[u], digits)} ${unit}`.trim()).join(', ');

  oddity.needName = (close, joined = ' and ') => Object.entries(close).map(([unit, x]) => oddity.nameOfNeed(unit, x)).join(joined);

  const fails = {
    'non-finite': 'the state is not finite',
    stalled: 'it is stuck',
    chattering: 'chattering, events without end',
    grazing: 'grazing, whether an event happens is below its error',
  };

  /** The outcome in a few words. */
  oddity.endingOf = function (motion, judged, { close, time_unit: unit }) {
    const at = (t) => `${written(t, 3)} ${unit}`;
    if (judged.broken !== null || motion.ending !== 'reached') {
      const why = fails[motion.ending] || motion.message || 'it ends';
      return { holds: false, text: judged.broken === null ? why : `breaks off at ${at(judged.broken)}: ${why}` };
    }
    if (!judged.count) return { holds: false, text: 'the truth is not known here' };
    if (judged.since === null) return { holds: true, text: `holds ${oddity.needName(close)}` };
    return { holds: false, text: `more than ${oddity.needName(close, ' or ')} off, first at ${at(judged.since)}` };
  };

  oddity.largestDrift = (motion) => motion.drift.reduce((most, x) => (x > most ? x : most), 0);

  function swatch(shape) {
    const canvas = oddity.make('canvas', { class: 'row-swatch', width: 68, height: 28, 'aria-hidden': 'true' });
    return { canvas, paint(colour) {
      const context = canvas.getContext('2d');
      context.setTransform(2, 0, 0, 2, 0, 0);
      context.clearRect(0, 0, 34, 14);
      context.strokeStyle = context.fillStyle = colour;
      context.lineWidth = 2;
      context.setLineDash(oddity.dashes[shape]);
      context.beginPath();
      context.moveTo(0, 7);
      context.lineTo(34, 7);
      context.stroke();
      oddity.mark(context, shape, 17, 7, 5);
    } };
  }

  function choice(label, changed) {
    const select = oddity.make('select', { 'aria-label': label, change: () => changed(select.value) });
    return { select, show(options, value) {
      select.replaceChildren(...options.map(([name, text]) => oddity.make('option', { value: name }, text)));
      select.value = value;
      select.disabled = options.length < 2;
    } };
  }

  const reading = (name, title) => {
    const value = oddity.make('dd', {});
    return { value, element: oddity.make('div', { class: 'reading', title }, oddity.make('dt', {}, name), value) };
  };

  function settingScale({ resolution }, { scene, frame, looks }) {
    const ends = resolution === 'tolerance' ? [1e-13, 0.1] : resolution === 'step' ? [frame / 64, scene.horizon / looks] : [1, 1024];
    return oddity.scaleOf({ value: ends[0], unit: resolution, least: ends[0], most: ends[1], whole: !['tolerance', 'step'].includes(resolution) });
  }

  /** {element, show(result), now(t), paint(colour)}; `changed(row)` receives the new row. */
  oddity.methodRow = function ({ motions, row, shape, changed, removed, refused }) {
    const { scene } = motions;
    const mark = swatch(shape);
    const model = choice('model', (name) => changed(another(name, row.algorithm)));
    const algorithm = choice('algorithm', (name) => changed(another(row.model, name)));
    const precision = choice('computed in', (name) => changed({ ...row, precision: name }));
    const resolutionPlace = oddity.make('div', { class: 'row-setting' });
    const errorNow = reading('error', 'distance from the truth now');
    const worst = reading('at worst', 'largest distance from the truth until the end');
    const drift = reading('conserved', 'largest change of energy and other conserved quantities, relative to their moving parts');
    const ending = oddity.make('p', { class: 'row-ending' });
    const remove = oddity.make('button', { type: 'button', class: 'row-remove', 'aria-label': 'remove this method', click: removed },
      oddity.icon({ d: 'M4 4 L12 12 M12 4 L4 12', fill: 'none', stroke: 'currentColor', 'stroke-width': 1.6 }));
    const element = oddity.make('div', { class: 'row', role: 'group' },
      oddity.make('div', { class: 'row-what' }, mark.canvas, model.select,
        oddity.make('div', { class: 'row-by' }, algorithm.select, precision.select), resolutionPlace, remove),
      oddity.make('div', { class: 'row-how' },
        oddity.make('dl', {}, errorNow.element, worst.element, drift.element), ending));
    let result = null;
    let slider = null;
    let sliderOf = null;

    /** Keeps the setting if its kind stays the same. */
    function another(modelName, algorithmName) {
      const was = motions.find(row.model, row.algorithm);
      const next = motions.find(modelName, algorithmName) || motions.algorithmsOf(modelName)[0];
      const same = next.resolution === was.resolution && !next.path && !was.path;
      return { ...row, model: next.model, algorithm: next.algorithm, trial: null,
        precision: next.precisions.includes(row.precision) ? row.precision : next.precisions[0],
        setting: same ? row.setting : motions.usual(next) };
    }

    function showSetting(method) {
      const kind = method.path ? 'recorded' : method.resolution;
      if (sliderOf !== kind) {
        sliderOf = kind;
        slider = null;
        resolutionPlace.replaceChildren();
        if (kind === 'recorded' && method.path.resolution)
          resolutionPlace.append(oddity.make('span', { class: 'row-fixed' }, ''));
        else if (kind && kind !== 'recorded')
          slider = oddity.slider({ name: kind, says: '', unit: kind === 'step' ? scene.time_unit : '',
            units: kind === 'step' ? motions.data.units[scene.time_unit] : {}, scale: settingScale(method, motions),
            value: row.setting, checked: (x) => (x > 0 ? '' : `The ${kind} has to be above 0.`),
            changed: (setting) => changed({ ...row, setting, trial: null }), refused });
        if (slider) resolutionPlace.append(slider.element);
      }
      if (slider) slider.show(row.setting);
      else if (resolutionPlace.firstChild) resolutionPlace.firstChild.textContent = `${method.path.resolution} ${oddity.inField(method.path.setting)}, recorded`;
    }

    function showMethod() {
      const method = motions.find(row.model, row.algorithm);
      model.show(motions.models.map((name) => [name, name]), row.model);
      algorithm.show(motions.algorithmsOf(row.model).map((m) =>
        [m.algorithm, m.path && !motions.recordedOnly ? `${m.algorithm} (recorded)` : m.algorithm]), row.algorithm);
      precision.show(method.precisions.map((name) => [name, name]), row.precision);
      showSetting(method);
      element.setAttribute('aria-label', `${row.model} by ${row.algorithm}`);
    }

    function showOutcome() {
      const { motion, judged, floors } = result;
      const low = judged.worst.every((x, u) => x <= floors[u]);
      worst.value.textContent = low ? `below ${oddity.amounts(floors, judged.units, 1)}` : oddity.amounts(judged.worst, judged.units);
      drift.element.hidden = !motion.drift.length;
      drift.value.textContent = motion.drift.length ? `\u00b1${oddity.part(oddity.largestDrift(motion))}` : '\u2013';
      const { holds, text } = oddity.endingOf(motion, judged, scene);
      ending.textContent = row.trial ? `${text}. ${row.trial}` : text;
      ending.className = `row-ending ${holds ? 'row-holds' : 'row-fails'}`;
      const last = motion.times.length - 1;  // all digits, for programs that read the page
      element.dataset.end = JSON.stringify({ observed: [...motion.observed.slice(last * motion.count)],
        errors: judged.errors.map((e) => e[last]), floors });
    }

    function showNothing() {
      for (const r of [errorNow, worst, drift]) r.value.textContent = '\u2013';
      ending.textContent = 'only recorded, at the parameters of the book';
      ending.className = 'row-ending';
    }

    return {
      element,
      /** Shows `{row, motion, judged, floors}`; `motion` may be null. */
      show(next) {
        result = next;
        row = next.row;
        showMethod();
        if (result.motion) showOutcome();
        else showNothing();
      },
      now(t) {
        if (!result || !result.motion) return;
        const { motion, judged, floors } = result;
        const i = oddity.placeOf(motion.times, t);
        const here = judged.errors.map((e) => e[i]);
        let text = oddity.amounts(here, judged.units);
        if (here.every((x, u) => x <= floors[u])) text = `below ${oddity.amounts(floors, judged.units, 1)}`;
        if (here.some(Number.isNaN)) text = '\u2013';
        if (judged.broken !== null && t >= judged.broken) text = 'broken off';
        if (errorNow.value.textContent !== text) errorNow.value.textContent = text;
      },
      paint: mark.paint,
      focus() { algorithm.select.focus({ preventScroll: true }); },
    };
  };
})(window.oddity = window.oddity || {});
