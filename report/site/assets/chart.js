// Work-precision diagrams: every <figure class="chart" data-quantity="NAME"> becomes one. The SVG is made here,
// without a library, as each point is an element that can be focused, names its trial and plays it.
(function (oddity) {
  'use strict';

  // ---- numbers ---------------------------------------------------------------------------------------------

  const superscripts = { '-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹' };
  const power = (exponent) => '10' + [...String(exponent)].map((c) => superscripts[c]).join('');

  function number(x, digits = 2) {
    if (x === null || x === undefined || Number.isNaN(x)) return 'no number';
    if (!Number.isFinite(x)) return x > 0 ? '∞' : '−∞';
    if (x === 0) return '0';
    const [mantissa, exponent] = x.toExponential(digits - 1).split('e');
    const size = Number(exponent);
    if (size >= -3 && size < 5) return String(Number(Number(x.toPrecision(digits)).toFixed(12)));
    const factor = Number(mantissa);
    return (factor === 1 ? '' : factor + '×') + power(size);
  }

  const count = (n) => String(n).replace(/\B(?=(\d{3})+$)/g, ',');

  function duration(ns, digits = 3) {
    if (ns === null) return 'not timed';
    const units = [[1e9, 's'], [1e6, 'ms'], [1e3, 'µs'], [1, 'ns']];
    const [size, unit] = units.find(([least]) => ns >= least) || [1, 'ns'];
    return number(ns / size, digits) + ' ' + unit;
  }

  const hasUnit = (unit) => unit && unit !== '1' && !unit.includes(',');
  const inUnit = (x, unit, digits) => number(x, digits) + (hasUnit(unit) && x !== null ? ' ' + unit : '');

  /** What a game asks, in the words of a game: "1 cm", "1°". */
  function needOfGame(value, unit) {
    if (unit === 'm' && value === 0.01) return '1 cm';
    if (unit === 'rad' && Math.abs(value * 180 / Math.PI - 1) < 1e-3) return '1°';
    return inUnit(value, unit);
  }

  function median(numbers) {
    const sorted = [...numbers].sort((a, b) => a - b);
    return sorted.length ? sorted[Math.floor(sorted.length / 2)] : NaN;
  }

  // ---- a quantity's methods and points ---------------------------------------------------------------------

  /** Of algorithms that integrate a motion, in the order of their colours. */
  const families = ['closed form', 'explicit steps', 'partitioned', 'step control', 'extrapolation', 'multistep', 'implicit'];
  const familyOf = (name) => (families.includes(name) ? families.indexOf(name) : families.length);
  const colourOf = (m, by) => `var(--${by}-${m.colours[by]})`;

  const failures = new Set(['X', 'N', 'S', 'R', 'C', 'G']);
  /** Which outcomes stand beside their point as a letter: `inaccurate` is seen from the line of the need. */
  const lettered = (outcome) => outcome !== 'o' && outcome !== 'i';

  /** The methods of a quantity, each with its place in the palettes and its trials as points. */
  function methodsOf(quantity, styles) {
    return quantity.methods.map((m, index) => {
      const method = {
        model: m.model, algorithm: m.algorithm, precision: m.precision, knob: m.knob, index,
        family: styles.families[m.algorithm] || m.algorithm,
        colours: { model: (styles.colours[m.model] || 0) % 11, family: familyOf(styles.families[m.algorithm]) },
        mark: styles.marks[m.algorithm] || 0,
      };
      method.points = m.trials.map(([setting, error, evaluations, ns, spread, outcome], place) =>
        ({ method, place, setting, error, evaluations, ns, spread, outcome }));
      return method;
    });
  }

  const usable = (p) => !failures.has(p.outcome) && p.error !== null;
  const cost = (p, axis) => axis === 'time' ? p.ns : Math.max(p.evaluations, 1);
  const named = (m) => m.algorithm + (m.precision === 'float' ? ' in float' : '') + ' (' + m.model + ')';

  /** The same in a sentence. */
  const spoken = (m) => m.algorithm === 'closed form' ? m.model + ' in closed form' + (m.precision === 'float' ? ' in float' : '') : named(m);
  /** A sentence begins with a capital, but for letters and names of functions. */
  const sentence = (text) => /^[a-z]{2,}[ ,-]/.test(text) ? text[0].toUpperCase() + text.slice(1) : text;

  /** Shorter: the algorithm, or the model of a closed form. */
  function called(m, withModel) {
    const name = m.algorithm === 'closed form' ? m.model : m.algorithm;
    return name + (m.precision === 'float' ? ' in float' : '') +
      (withModel && m.algorithm !== 'closed form' ? ' (' + m.model + ')' : '');
  }

  /** The points that no other beats: none costs no more and errs no more, and is better in one of the two. */
  function front(points, axis, floor) {
    const able = points.filter((p) => usable(p) && cost(p, axis) !== null && !Number.isNaN(cost(p, axis)));
    const error = (p) => Math.max(p.error, floor);
    able.sort((a, b) => cost(a, axis) - cost(b, axis) || error(a) - error(b));
    let least = Infinity, at = NaN;
    return able.filter((p) => {
      const tie = cost(p, axis) === at && error(p) === least;
      if (!tie && error(p) >= least) return false;
      least = error(p);
      at = cost(p, axis);
      return true;
    });
  }

  /** Whether a is the better point: ok and cheaper, or else nearer to the truth. */
  function preferable(a, b, axis) {
    if ((a.outcome === 'o') !== (b.outcome === 'o')) return a.outcome === 'o';
    if (a.outcome !== 'o') return a.error !== null && (b.error === null || a.error < b.error);
    return cost(a, axis) !== cost(b, axis) ? cost(a, axis) < cost(b, axis) : a.error < b.error;
  }

  const best = (points, axis) => points.reduce((a, b) => (preferable(b, a, axis) ? b : a));

  /** The knob that a chart over settings shows: that of most methods, a tolerance only if there is no other. */
  function mainKnob(methods) {
    const counts = {};
    for (const m of methods) if (m.knob) counts[m.knob] = (counts[m.knob] || 0) + 1;
    const knobs = Object.keys(counts).sort((a, b) => counts[b] - counts[a]);
    return knobs.find((knob) => knob !== 'tolerance') || knobs[0] || '';
  }

  // ---- where the points lie --------------------------------------------------------------------------------

  const decadeBelow = (x) => Math.floor(Math.log10(x) + 1e-9);
  const decadeAbove = (x) => Math.ceil(Math.log10(x) - 1e-9);

  function decades(numbers) {
    if (!numbers.length) return { low: 0, high: 1, log: true };
    const low = decadeBelow(Math.min(...numbers));
    return { low, high: Math.max(decadeAbove(Math.max(...numbers)), low + 1), log: true };
  }

  /** The ranges of both axes, as exponents of ten where they are logarithmic, and where each point belongs. */
  function frame(quantity, methods, axis) {
    const knob = mainKnob(methods);
    const isLine = (m) => axis === 'setting' && !m.knob;
    const abscissa = (p) => axis !== 'setting' ? cost(p, axis) : p.method.knob === knob ? p.setting : isLine(p.method) ? edge : NaN;
    let edge = 1;  // where a method without a knob has its point, its line running from there
    const top = Math.max(1e3 * quantity.size, 10 * quantity.need) || 1;
    const points = methods.flatMap((m) => m.points);
    const errors = points.map((p) => p.error).filter((e) => e > 0 && e <= top);
    // An error of none stands a decade below the least that there is, or at the floor.
    const least = Math.max(quantity.floor, errors.length ? Math.min(...errors.filter((e) => e >= quantity.floor),
      quantity.need || Infinity) / 10 : 0);
    const within = (p) => p.error !== null && p.error <= top;
    const shown = points.filter((p) => abscissa(p) > 0);
    const seen = shown.filter(within).map((p) => Math.max(p.error, least));
    const xs = shown.filter((p) => !isLine(p.method)).map(abscissa);
    const few = axis === 'setting' && Math.min(...xs) >= 1 && Math.max(...xs) < 100;
    const x = few ? { low: Math.min(...xs) - 1, high: Math.max(...xs) + 1, log: false } : decades(xs);
    edge = few ? x.low : Math.pow(10, x.low);
    return {
      axis, knob, abscissa, within, isLine, x,
      y: decades(seen.concat(quantity.need > 0 ? [quantity.need] : [])),
      ordinate: (p) => Math.max(p.error, least),
      strip: shown.some((p) => !within(p)),
      floored: shown.some((p) => p.error !== null && p.error < quantity.floor),
      shows: (m) => m.points.some((p) => abscissa(p) > 0),
    };
  }

  const part = (range, value) => ((range.log ? Math.log10(value) : value) - range.low) / (range.high - range.low);

  /** Decades for ticks, at most `most` of them; whole numbers where the axis is linear. */
  function ticks(range, most) {
    const every = Math.max(1, Math.ceil((range.high - range.low) / most));
    const all = [];
    for (let at = Math.ceil(range.low); at <= range.high; ++at)
      if ((at - Math.ceil(range.low)) % every === 0) all.push(range.log ? Math.pow(10, at) : at);
    return all;
  }

  // ---- what is worth seeing --------------------------------------------------------------------------------

  const mostCurves = 8;

  /** The methods drawn in colour at first sight: those of the title, on the Pareto front, the best of each family. */
  function highlighted(methods, at, floor, spokenOf = []) {
    if (methods.length <= mostCurves) return new Set(methods);
    const chosen = new Set(spokenOf.filter((m) => methods.includes(m))), alike = [];
    const lookAlike = (p, q) => Math.abs(Math.log10(at.abscissa(p) / at.abscissa(q))) < 0.05 &&
      Math.abs(Math.log10(at.ordinate(p) / at.ordinate(q))) < 0.3;
    if (at.axis !== 'setting')
      for (const p of front(methods.flatMap((m) => m.points), at.axis, floor)) {
        if (alike.some((q) => lookAlike(p, q))) continue;
        alike.push(p);
        if (chosen.size < mostCurves) chosen.add(p.method);
      }
    const families = new Map();
    for (const m of methods) {
      const mine = best(m.points, at.axis), other = families.get(m.family);
      if (!other || preferable(mine, other, at.axis)) families.set(m.family, mine);
    }
    const ranked = [...families.values()].sort((a, b) => (preferable(a, b, at.axis) ? -1 : 1));
    for (const p of ranked) if (chosen.size < mostCurves) chosen.add(p.method);
    return chosen;
  }

  // ---- what a chart finds ----------------------------------------------------------------------------------

  const work = (p, axis) => axis === 'time' ? duration(p.ns)
    : count(p.evaluations) + (p.evaluations === 1 ? ' evaluation' : ' evaluations');

  function cheapest(methods, axis, allowed) {
    const points = methods.flatMap((m) => m.points).filter((p) => usable(p) && p.error <= allowed && cost(p, axis) !== null);
    return points.length ? points.reduce((a, b) => (cost(b, axis) < cost(a, axis) ||
      (cost(b, axis) === cost(a, axis) && b.error < a.error) ? b : a)) : null;
  }

  const integrates = (m) => m.knob === 'step' || m.knob === 'tolerance';

  /** Of a motion, at what a game asks: "velocity Verlet needs 80 evaluations, 32 times fewer than explicit Euler". */
  function findingOfMotion(methods, axis, game) {
    const integrators = methods.filter(integrates), closed = methods.filter((m) => !integrates(m));
    const several = new Set(integrators.map((m) => m.model)).size > 1;
    const within = 'Within ' + game.says + ', ';
    const least = cheapest(integrators, axis, game.error), exact = cheapest(closed, axis, game.error);
    const known = !exact ? '' : exact.method.model + (exact.method.algorithm === 'closed form' ? ' in closed form' : ' by ' + exact.method.algorithm) +
      ' needs ' + work(exact, axis);
    if (!least) return { says: exact ? within + known + '; no integrator comes there.' : 'No method stays within ' + game.says + '.',
      of: exact ? [exact.method] : [] };
    const plain = cheapest(integrators.filter((m) => m.algorithm === 'explicit Euler'), axis, game.error);
    const said = called(least.method, several) + ' needs ' + work(least, axis);
    const many = plain ? cost(plain, axis) / cost(least, axis) : NaN;
    const beside = least.method.algorithm === 'explicit Euler' ? ', the least of all integrators'
      : many >= 1.2 ? ', ' + number(many) + ' times ' + (axis === 'time' ? 'less' : 'fewer') + ' than explicit Euler'
      : !plain && integrators.some((m) => m.algorithm === 'explicit Euler') ? '; explicit Euler does not come there' : '';
    const cheaper = exact && cost(exact, axis) < cost(least, axis);
    return { says: within + said + beside + (cheaper ? '; ' + known : '') + '.',
      of: [least, plain, cheaper ? exact : null].filter(Boolean).map((p) => p.method) };
  }

  /** Of answers that are right or wrong, or of one point a method. */
  function findingOfRows(methods) {
    const right = methods.filter((m) => m.points[m.points.length - 1].outcome === 'o');
    const all = count(methods.length);
    const finest = right.some((m) => m.points.some((p) => p.outcome !== 'o')) ? ' at their finest setting.' : '.';
    if (methods.length === 1) return named(methods[0]) + ' is ' + (right.length ? '' : 'not ') + 'as exact as needed' + finest;
    if (!right.length) return 'None of ' + all + ' methods is as exact as needed.';
    if (right.length === methods.length) return (right.length === 2 ? 'Both' : 'All ' + all) + ' methods are as exact as needed' + finest;
    const wrong = methods.filter((m) => !right.includes(m));
    const few = (list) => list.length <= 2 ? list.map(named).join(' and ') : count(list.length);
    return right.length <= wrong.length ? 'Only ' + few(right) + ' of ' + all + ' methods ' +
      (right.length === 1 ? 'is' : 'are') + ' as exact as needed.'
      : few(right) + ' of ' + all + ' methods are as exact as needed; not ' + few(wrong) + '.';
  }

  /** What a chart says, and of which methods: {says, of}. */
  function finding(quantity, methods, axis, game) {
    if (!methods.length) return { says: 'Nothing is shown.', of: [] };
    if (!axis) return { says: findingOfRows(methods), of: [] };
    if (axis === 'setting') return findingOfSettings(quantity, methods);
    if (game) return findingOfMotion(methods, axis, game);
    return findingOfWork(quantity, methods, axis);
  }

  function findingOfSettings(quantity, methods) {
    const knob = mainKnob(methods), setting = /^(step|tolerance|distance|pulse|softness|amplitude)$/.test(knob) ? 'a ' + knob : 'the setting "' + knob + '"';
    const points = methods.filter((m) => m.knob === knob).flatMap((m) => m.points).filter(usable);
    if (!points.length) return { says: 'No method with ' + setting + ' comes to its end.', of: [] };
    const least = points.reduce((a, b) => (b.error < a.error ? b : a));
    return { says: 'Of the methods with ' + setting + ', ' + spoken(least.method) + ' is the most accurate: ' +
      inUnit(least.error, quantity.unit) + ' at ' + number(least.setting, 3) + '.', of: [least.method] };
  }

  function findingOfWork(quantity, methods, axis) {
    const needed = quantity.asked || inUnit(quantity.need, quantity.unit);
    const least = cheapest(methods, axis, quantity.need);
    if (!least) {
      const points = methods.flatMap((m) => m.points).filter(usable);
      if (!points.length) return { says: 'No method comes to an end.', of: [] };
      const nearest = points.reduce((a, b) => (b.error < a.error ? b : a));
      return { says: 'No method reaches ' + needed + '; the closest is ' + spoken(nearest.method) + ': ' +
        inUnit(nearest.error, quantity.unit) + '.', of: [nearest.method] };
    }
    const others = methods.filter((m) => m.family !== least.method.family || m.model !== least.method.model);
    const next = cheapest(others, axis, quantity.need);
    const many = next ? cost(next, axis) / cost(least, axis) : 0;
    return { says: spoken(least.method) + ' reaches ' + needed + ' with the least work: ' + work(least, axis) +
      (many >= 1.5 ? '; ' + spoken(next.method) + ' needs ' + number(many) + ' times as much' : '') + '.',
    of: many >= 1.5 ? [least.method, next.method] : [least.method] };
  }

  function settingOf(p, timeUnit) {
    const { knob } = p.method;
    if (!knob) return '';
    return knob + ' ' + number(p.setting, 3) + (knob === 'step' && timeUnit ? ' ' + timeUnit : '');
  }

  /** All that is known of a trial, in lines. */
  function description(p, quantity, context) {
    const lines = [named(p.method)];
    const setting = settingOf(p, context.timeUnit);
    if (setting) lines.push(setting);
    lines.push('error ' + (p.error === null ? 'not a number' : inUnit(p.error, quantity.unit, 3)));
    lines.push(work(p, 'evaluations'));
    if (p.ns !== null) lines.push(duration(p.ns) + (p.spread === null ? '' : ' ± ' + duration(p.spread, 2)));
    lines.push(context.outcomes[p.outcome] || p.outcome);
    return lines;
  }

  // ---- elements --------------------------------------------------------------------------------------------

  function element(name, attributes = {}, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) if (value !== undefined) made.setAttribute(key, value);
    made.append(...children);
    return made;
  }

  function svg(name, attributes = {}, ...children) {
    const made = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    made.append(...children);
    return made;
  }

  const shapes = [
    (r) => `M${-r},0a${r},${r} 0 1,0 ${2 * r},0a${r},${r} 0 1,0 ${-2 * r},0z`,
    (r) => `M${-r * 0.9},${-r * 0.9}h${r * 1.8}v${r * 1.8}h${-r * 1.8}z`,
    (r) => `M0,${-r * 1.2}L${r * 1.15},${r * 0.8}H${-r * 1.15}z`,
    (r) => `M0,${r * 1.2}L${r * 1.15},${-r * 0.8}H${-r * 1.15}z`,
    (r) => `M0,${-r * 1.35}L${r * 1.1},0L0,${r * 1.35}L${-r * 1.1},0z`,
    (r) => 'M' + [0, 1, 2, 3, 4].map((i) => [1.2 * r * Math.sin(i * 0.4 * Math.PI), -1.2 * r * Math.cos(i * 0.4 * Math.PI)]
      .map((x) => x.toFixed(2)).join(',')).join('L') + 'z',
  ];

  /** An algorithm's mark: a shape, filled or open; those after the first twelve have a dot or a bar in it. */
  function mark(place, r = 4) {
    const kind = Math.floor(place / 12) % 3, open = place % 12 >= 6;
    const group = svg('g', { class: 'mark' + (open ? ' open' : '') });
    group.append(svg('path', { d: shapes[place % 6](r), class: 'shape' }));
    if (kind === 1) group.append(svg('circle', { r: r * 0.4, class: 'inner' }));
    if (kind === 2) group.append(svg('path', { d: `M${-r * 1.5},0H${r * 1.5}`, class: 'bar' }));
    return group;
  }

  function swatch(...drawn) {
    return svg('svg', { class: 'swatch', viewBox: '-8 -8 16 16', width: 16, height: 16, 'aria-hidden': 'true' }, ...drawn);
  }

  let pen = null;
  function widthOf(text, font) {
    if (!pen) pen = document.createElement('canvas').getContext('2d');
    pen.font = font;
    return pen.measureText(text).width;
  }

  /** A row of buttons of which one is pressed. */
  function choice(says, options, chosen, choose) {
    const group = element('div', { class: 'choice', role: 'group', 'aria-label': says });
    for (const [value, text] of options) {
      const button = element('button', { type: 'button', 'aria-pressed': String(value === chosen) }, text);
      button.addEventListener('click', () => {
        for (const other of group.children) other.setAttribute('aria-pressed', String(other === button));
        choose(value);
      });
      group.append(button);
    }
    return group;
  }

  // ---- labels ----------------------------------------------------------------------------------------------

  const overlap = (a, b) => Math.max(0, Math.min(a.right, b.right) - Math.max(a.left, b.left)) *
    Math.max(0, Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));

  /** Places for a label of this width beside a point. */
  function beside(spot, width, height) {
    const middle = { top: spot.y - height / 2, bottom: spot.y + height / 2 };
    const box = (left, top) => ({ left, right: left + width, top, bottom: top + height });
    return [
      { left: spot.x + 9, right: spot.x + 9 + width, ...middle },
      { left: spot.x - 9 - width, right: spot.x - 9, ...middle },
      box(spot.x + 6, spot.y - height - 5), box(spot.x + 6, spot.y + 5),
      box(spot.x - 6 - width, spot.y - height - 5), box(spot.x - 6 - width, spot.y + 5),
      box(spot.x - width / 2, spot.y - height - 8), box(spot.x - width / 2, spot.y + 8),
      ...[24, 40, 56].flatMap((away) => [box(spot.x + 12, spot.y - height - away), box(spot.x - 12 - width, spot.y - height - away),
        box(spot.x + 12, spot.y + away), box(spot.x - 12 - width, spot.y + away)]),
    ];
  }

  /** Where the labels go: at an end of their curves where nothing is covered, as near to that as can be. */
  function placeLabels(curves, bounds, obstacles = [], height = 15) {
    const dots = curves.flatMap((c) => c.way.map((spot) => ({ ...spot, curve: c })));
    const placed = [...obstacles];
    for (const curve of curves) {
      let least = Infinity, found = null;
      curve.spots.forEach((spot, i) => {
        const away = 4 * Math.min(curve.spots.length - 1 - i, i + 1);
        for (const [k, box] of beside(spot, curve.width, height).entries()) {
          const outside = box.left < bounds.left || box.right > bounds.right || box.top < bounds.top || box.bottom > bounds.bottom;
          const covered = dots.filter((d) => d.x > box.left - 3 && d.x < box.right + 3 && d.y > box.top - 2 && d.y < box.bottom + 2);
          const price = (outside ? 1e4 : 0) + 20 * placed.reduce((sum, other) => sum + overlap(box, other), 0) +
            6 * covered.length + away + (k < 8 ? 0.3 * k : k);
          if (price < least) [least, found] = [price, { ...box, curve, spot }];
        }
      });
      if (found) placed.push(found);
    }
    return placed.slice(obstacles.length);
  }

  /** The way of a curve, a spot every few pixels. */
  function way(spots, every = 7) {
    const all = [];
    spots.forEach((spot, i) => {
      const next = spots[i + 1] || spot;
      const parts = Math.max(1, Math.round(Math.hypot(next.x - spot.x, next.y - spot.y) / every));
      for (let k = 0; k < parts; ++k)
        all.push({ x: spot.x + (next.x - spot.x) * k / parts, y: spot.y + (next.y - spot.y) * k / parts });
    });
    return all;
  }

  const shortened = (text, most) => text.length <= most ? text : text.slice(0, most - 1).trimEnd() + '…';

  /** The names of curves: as short as tells them apart. */
  function namesOf(methods) {
    const short = methods.map((m) => called(m, false));
    return methods.map((m, i) => shortened(short[i], 34) +
      (short.filter((other) => other === short[i]).length > 1 ? ', ' + shortened(m.model, 22) : ''));
  }

  // ---- the chart -------------------------------------------------------------------------------------------

  let last = null;  // the point that was named last, on whatever it was
  if (typeof document !== 'undefined') document.addEventListener('oddity:point', (event) => { last = event.detail; });
  const said = (detail) => document.dispatchEvent(new CustomEvent('oddity:point', { detail }));
  const play = (detail) => document.dispatchEvent(new CustomEvent('oddity:play', { detail }));

  const detailOf = (p, quantity) => ({
    quantity: quantity.name, model: p.method.model, algorithm: p.method.algorithm,
    precision: p.method.precision, setting: p.setting,
  });

  const isOf = (p, detail) => p.method.model === detail.model && p.method.algorithm === detail.algorithm &&
    p.method.precision === detail.precision;
  const isPoint = (p, detail) => isOf(p, detail) && Math.abs(p.setting - detail.setting) <= 1e-6 * Math.abs(p.setting);

  /** What is shown: kinds of names that are switched off. */
  function filter() {
    const off = { model: new Set(), algorithm: new Set(), precision: new Set(['float']), outcome: new Set() };
    return {
      off,
      method: (m) => !off.model.has(m.model) && !off.algorithm.has(m.algorithm) && !off.precision.has(m.precision),
      point: (p) => !off.outcome.has(p.outcome),
    };
  }

  /** The methods that the filter leaves, with the points that it leaves. */
  function left(methods, shown) {
    return methods.filter(shown.method).map((m) => {
      const copy = { ...m };
      copy.points = m.points.filter(shown.point).map((p) => ({ ...p, method: copy }));
      return copy;
    }).filter((m) => m.points.length);
  }

  const axisTitles = { time: 'time', evaluations: 'evaluations' };

  /** What is counted, as far as the knobs tell. */
  function counted(methods) {
    const differs = methods.some((m) => m.algorithm.includes('difference'));
    const steps = methods.some((m) => m.knob === 'step');
    const nodes = methods.some((m) => m.knob === 'panels' || m.knob === 'points');
    return 'evaluations' + (differs ? ' of the function' : steps && nodes ? ' of the right-hand side or integrand'
      : steps ? ' of the right-hand side' : nodes ? ' of the integrand' : '');
  }

  /** A chart in a figure. `context`: styles, outcomes, timeUnit, close: [{error, says}], what a
   *  game asks in each unit, game: the same in one or null, plays: clicks play, floats: those in float are on,
   *  chosen: a method that is always in colour. */
  function chart(figure, quantity, context) {
    const all = methodsOf(quantity, context.styles);
    const shown = filter();
    context.font = () => getComputedStyle(plot).fontFamily;
    if (context.floats || !all.some((m) => m.precision === 'double')) shown.off.precision.clear();
    const families = new Set(all.map((m) => context.styles.families[m.algorithm]).filter(Boolean));
    const view = { axis: quantity.charts[0] || null, every: false, picked: last && last.quantity === quantity.name ? last : null, by: families.size > 2 ? 'family' : 'model' };
    const title = element('strong', { class: 'finding' });
    const subtitle = element('span', { class: 'says' });
    const plot = element('div', { class: 'plot' });
    const tip = element('div', { class: 'tip', 'aria-hidden': 'true', hidden: '' });
    let spots = [];

    function draw() {
      const methods = left(all, shown);
      const found = finding(quantity, methods, view.axis, context.game);
      title.textContent = sentence(found.says);
      const chosen = methods.filter((m) => context.chosen && isOf(m.points[0], context.chosen));
      const drawing = view.axis ? workPrecision(quantity, methods, chosen.concat(found.of), view, context, plot.clientWidth)
        : rows(quantity, methods, view, context, plot.clientWidth);

      spots = drawing.spots;
      drawing.svg.setAttribute('aria-label', title.textContent + ' Each point is a trial; the arrow keys go from one to the next.');
      plot.replaceChildren(drawing.svg, tip);
      tip.hidden = true;
      const at = spots.find((s) => view.picked && isPoint(s.point, view.picked)) || spots.find((s) => s.first) || spots[0];
      if (at) at.node.setAttribute('tabindex', '0');
      if (view.picked) light(view.picked);
    }

    function light(detail) {
      for (const s of spots) {
        s.node.classList.toggle('lit', isPoint(s.point, detail));
        if (s.curve) s.curve.classList.toggle('lit', isOf(s.point, detail));
      }
    }

    function show(spot) {
      for (const s of spots) s.node.setAttribute('tabindex', s === spot ? '0' : '-1');
      const lines = description(spot.point, quantity, context);
      tip.replaceChildren(element('b', {}, lines[0]), ...lines.slice(1).map((line) => element('span', {}, line)));
      if (context.plays) tip.append(element('i', {}, 'click plays it'));
      tip.hidden = false;
      const right = spot.x + 14 + tip.offsetWidth < plot.clientWidth;
      tip.style.left = Math.max(0, right ? spot.x + 14 : spot.x - 14 - tip.offsetWidth) + 'px';
      tip.style.top = Math.max(0, Math.min(spot.y - 20, plot.clientHeight - tip.offsetHeight)) + 'px';
    }

    function pick(spot) {
      const detail = detailOf(spot.point, quantity);
      show(spot);
      if (view.picked && isPoint(spot.point, view.picked)) return;
      view.picked = detail;
      said(detail);
    }

    function nearest(event) {
      const box = plot.getBoundingClientRect();
      const x = event.clientX - box.left, y = event.clientY - box.top;
      const far = (s) => Math.hypot(s.x - x, s.y - y) + (s.pale ? 6 : 0);
      const found = spots.reduce((a, b) => (a && far(a) <= far(b) ? a : b), null);
      return found && far(found) < 26 ? found : null;
    }

    function neighbour(spot, key) {
      const order = [...new Set(spots.map((s) => s.point.method))];
      const mine = spots.filter((s) => s.point.method === spot.point.method);
      const place = mine.indexOf(spot), step = key === 'ArrowRight' || key === 'ArrowDown' ? 1 : -1;
      if (key === 'Home') return mine[0];
      if (key === 'End') return mine[mine.length - 1];
      if (key === 'ArrowLeft' || key === 'ArrowRight') return mine[place + step];
      const other = order[order.indexOf(spot.point.method) + step];
      const theirs = spots.filter((s) => s.point.method === other);
      return theirs.reduce((a, b) => (a && Math.abs(a.x - spot.x) <= Math.abs(b.x - spot.x) ? a : b), null);
    }

    plot.addEventListener('pointermove', (event) => {
      if (event.pointerType === 'touch') return;
      const spot = nearest(event);
      plot.classList.toggle('answers', Boolean(spot && context.plays));
      if (spot) pick(spot);
      else tip.hidden = true;
    });
    plot.addEventListener('pointerleave', () => { tip.hidden = true; });
    plot.addEventListener('click', (event) => {
      const spot = nearest(event);
      if (!spot) return;
      const again = view.picked && isPoint(spot.point, view.picked) && !tip.hidden;
      pick(spot);
      if (context.plays && (event.pointerType !== 'touch' || again)) play(detailOf(spot.point, quantity));
    });
    plot.addEventListener('focusin', (event) => {
      const spot = spots.find((s) => s.node === event.target);
      if (spot) pick(spot);
    });
    plot.addEventListener('focusout', () => { tip.hidden = true; });
    plot.addEventListener('keydown', (event) => {
      const spot = spots.find((s) => s.node === document.activeElement);
      if (!spot) return;
      if (event.key === 'Escape') tip.hidden = true;
      else if (event.key === 'Enter' || event.key === ' ') { if (context.plays) play(detailOf(spot.point, quantity)); }
      else if (/^(Arrow|Home$|End$)/.test(event.key)) {
        const next = neighbour(spot, event.key);
        if (next) next.node.focus();
      } else return;
      event.preventDefault();
    });
    document.addEventListener('oddity:point', function heard(event) {
      if (!plot.isConnected) document.removeEventListener('oddity:point', heard);
      if (!event.detail || event.detail.quantity !== quantity.name || event.detail.parameters) return;
      view.picked = event.detail;
      light(event.detail);
    });

    const tools = element('div', { class: 'tools' });
    if (quantity.charts.length > 1) {
      const names = { ...axisTitles, setting: mainKnob(all) };
      tools.append(choice('error against', quantity.charts.map((axis) => [axis, names[axis]]), view.axis,
        (axis) => { view.axis = axis; draw(); }));
    }
    if (view.axis && all.length > mostCurves)
      tools.append(choice('curves', [[false, 'the best'], [true, 'all']], false, (every) => { view.every = every; draw(); }));
    if (families.size > 2 && new Set(all.map((m) => m.model)).size > 1)
      tools.append(choice('colours', [['family', 'colours by algorithm'], ['model', 'by model']], view.by,
        (by) => { view.by = by; draw(); recolour(); }));
    const [buttons, recolour] = legend(all, shown, context, view, draw);
    subtitle.textContent = quantity.says + (quantity.samples > 1 ? '; judged at these ' + quantity.samples + ' times alone' : '');
    figure.replaceChildren(element('figcaption', {}, title, subtitle), tools, plot, buttons);
    draw();
    let wide = plot.clientWidth;
    if (typeof ResizeObserver !== 'undefined')
      new ResizeObserver(() => {
        if (Math.abs(plot.clientWidth - wide) < 4) return;
        wide = plot.clientWidth;
        draw();
      }).observe(plot);
    return { redraw: draw };
  }

  /** Buttons that switch models, algorithms, precisions and outcomes on and off; and what colours them anew. */
  function legend(methods, shown, context, view, draw) {
    const details = element('details', { class: 'legend' }, element('summary', {}, 'Show and hide'));
    const distinct = (values) => [...new Set(values)];
    const letters = Object.keys(context.outcomes);
    const ofKind = { model: (name) => methods.find((m) => m.model === name), algorithm: (name) => methods.find((m) => m.algorithm === name) };
    const kinds = [
      ['model', 'models', distinct(methods.map((m) => m.model)),
        () => swatch(svg('rect', { x: -7, y: -4, width: 14, height: 8, class: 'fill' }))],
      ['algorithm', 'algorithms', distinct(methods.map((m) => m.algorithm)),
        (name) => swatch(mark(ofKind.algorithm(name).mark, 4.6))],
      ['precision', 'precisions', distinct(methods.map((m) => m.precision)),
        (name) => swatch(svg('path', { d: 'M-8,0H8', class: 'line ' + name }))],
      ['outcome', 'outcomes', distinct(methods.flatMap((m) => m.points.map((p) => p.outcome)))
        .sort((a, b) => letters.indexOf(a) - letters.indexOf(b)),
        (letter) => lettered(letter) ? element('span', { class: 'letter', 'aria-hidden': 'true' }, letter) : ''],
    ].filter(([, , names]) => names.length > 1);
    const coloured = [];
    for (const [kind, says, names, picture] of kinds) {
      const off = shown.off[kind];
      const buttons = names.map((name) => {
        const button = element('button', { type: 'button' }, picture(name), kind === 'outcome' ? context.outcomes[name] || name : name);
        if (ofKind[kind]) coloured.push([kind, ofKind[kind](name), button]);
        button.addEventListener('click', () => {
          if (!off.delete(name)) off.add(name);
          refresh();
        });
        return button;
      });
      const all = element('button', { type: 'button', class: 'everything' });
      all.addEventListener('click', () => {
        if (off.size) off.clear();
        else names.forEach((name) => off.add(name));
        refresh();
      });
      const press = () => {
        names.forEach((name, i) => buttons[i].setAttribute('aria-pressed', String(!off.has(name))));
        all.textContent = off.size ? 'all on' : 'all off';
      };
      const refresh = () => { press(); draw(); };
      press();
      details.append(element('div', { class: 'kind', role: 'group', 'aria-label': says },
        element('span', { class: 'kind-name' }, says), ...buttons, ...(names.length > 4 ? [all] : [])));
    }
    const recolour = () => {
      for (const [kind, m, button] of coloured)
        button.style.setProperty('--c', (kind === 'model') === (view.by === 'model') ? colourOf(m, view.by) : 'currentColor');
    };
    recolour();
    details.open = figureIsWide() && kinds.reduce((sum, [, , names]) => sum + names.length, 0) <= 14;
    return [kinds.length ? details : '', recolour];
  }

  const figureIsWide = () => window.matchMedia('(min-width: 700px)').matches;

  // ---- its drawings ----------------------------------------------------------------------------------------

  /** A point as an element: pale ones are dots, those without a number letters. */
  function nodeOf(p, quantity, context, pale, inStrip) {
    const node = svg('g', {
      class: 'point' + (pale ? ' pale' : ''), tabindex: -1, role: context.plays ? 'button' : 'img',
      'aria-label': description(p, quantity, context).join(', ') + (context.plays ? '; Enter plays it' : ''),
    });
    node.append(svg('circle', { class: 'halo', r: 9 }));
    if (inStrip) node.append(svg('text', { class: 'letter', y: 4, 'text-anchor': 'middle' }, p.outcome));
    else node.append(pale ? svg('circle', { class: 'dot', r: 2 }) : mark(p.method.mark));
    if (!inStrip && !pale && lettered(p.outcome)) node.append(svg('text', { class: 'letter', x: 6, y: -4 }, p.outcome));
    return node;
  }

  function tickText(axis, value) {
    if (axis === 'time') return duration(value, 1);
    if (value >= 0.01 && value < 1e4) return number(value, 3);
    return power(Math.round(Math.log10(value)));
  }

  /** Error against evaluations, time or the setting, both logarithmic. */
  function workPrecision(quantity, methods, spokenOf, view, context, width) {
    const narrow = width < 560;
    const at = frame(quantity, methods, view.axis);
    const box = { left: narrow ? 46 : 62, right: width - (narrow ? 10 : 150), top: at.strip ? 46 : 14, bottom: 0 };
    const height = Math.round(Math.max(narrow ? 360 : 400, Math.min(520, width * 0.55)));
    box.bottom = height - 46;
    const x = (value) => box.left + (box.right - box.left) * part(at.x, value);
    const y = (value) => box.bottom - (box.bottom - box.top) * part(at.y, value);
    const spotOf = (p) => ({
      point: p, x: Math.max(box.left, x(at.abscissa(p))), y: at.within(p) ? y(at.ordinate(p)) : box.top - 17,
    });
    const drawn = methods.filter(at.shows);
    const bright = view.every ? new Set(drawn) : highlighted(drawn, at, quantity.floor, spokenOf);
    const picture = svg('svg', { class: 'work-precision', viewBox: `0 0 ${width} ${height}`, width, height, role: 'group' });
    const spots = [], curves = [], obstacles = [];
    picture.append(axes(at, box, x, y, quantity, methods, context, narrow, obstacles));
    const points = (m) => m.points.filter((p) => at.abscissa(p) > 0);
    const back = svg('g'), middle = svg('g'), fore = svg('g');
    for (const m of drawn) {
      const pale = !bright.has(m);
      const curve = svg('g', { class: 'curve' + (pale ? ' pale' : '') + (m.precision === 'float' ? ' float' : '') });
      curve.style.setProperty('--c', colourOf(m, view.by));
      const mine = points(m).map(spotOf);
      const inside = mine.filter((s) => at.within(s.point));
      curve.append(svg('path', { class: 'line', d: inside.map((s, i) => (i ? 'L' : 'M') + s.x.toFixed(1) + ',' + s.y.toFixed(1)).join('') +
        (at.isLine(m) && inside.length ? 'H' + box.right : '') }));
      for (const s of mine) {
        s.node = nodeOf(s.point, quantity, context, pale, !at.within(s.point));
        s.node.setAttribute('transform', `translate(${s.x.toFixed(1)},${s.y.toFixed(1)})`);
        Object.assign(s, { pale, curve });
        if (view.axis === 'time' && !pale) curve.append(spreadOf(s, x));
        curve.append(s.node);
        spots.push(s);
        if (!pale && lettered(s.point.outcome)) obstacles.push({ left: s.x + 5, right: s.x + 14, top: s.y - 14, bottom: s.y - 3 });
      }
      (pale ? back : fore).append(curve);
      if (!pale && mine.length) curves.push({ method: m, spots: inside.length ? inside : mine, way: way(inside) });
    }
    if (view.axis !== 'setting') middle.append(frontLine(methods, view.axis, quantity.floor, spots, box));
    picture.append(back, middle, fore, labels(curves, obstacles, view, context, { left: narrow ? 2 : box.left + 2, right: width - 2, top: 4, bottom: box.bottom - 2 }, narrow));
    const first = front(methods.flatMap((m) => m.points), view.axis, quantity.floor)[0];
    const start = spots.find((s) => s.point === first);
    if (start) start.first = true;
    return { svg: picture, spots };
  }

  function spreadOf(spot, x) {
    const { ns, spread } = spot.point;
    const low = x(Math.max(ns - spread, ns / 2)), high = x(ns + spread);
    return svg('path', { class: 'spread', d: spread && high - low > 2 ? `M${low.toFixed(1)},${spot.y.toFixed(1)}H${high.toFixed(1)}` : 'M0,0' });
  }

  function frontLine(methods, axis, floor, spots, box) {
    const best = new Set(front(methods.flatMap((m) => m.points), axis, floor));
    const steps = spots.filter((s) => best.has(s.point)).sort((a, b) => a.x - b.x || b.y - a.y);
    if (!steps.length) return '';
    const d = steps.map((s, i) => (i ? `H${s.x.toFixed(1)}V${s.y.toFixed(1)}` : `M${s.x.toFixed(1)},${s.y.toFixed(1)}`)).join('');
    return svg('path', { class: 'front', d: d + `H${box.right}` });
  }

  function axes(at, box, x, y, quantity, methods, context, narrow, obstacles) {
    const group = svg('g', { class: 'axes', 'aria-hidden': 'true' });
    const line = (attributes, d) => group.append(svg('path', { ...attributes, d }));
    const text = (says, attributes) => group.append(svg('text', attributes, says));
    for (const value of ticks(at.y, narrow ? 8 : 12)) {
      line({ class: 'grid' }, `M${box.left},${y(value).toFixed(1)}H${box.right}`);
      text(tickText('error', value), { x: box.left - 6, y: y(value) + 4, 'text-anchor': 'end' });
    }
    for (const value of ticks(at.x, narrow ? 5 : 9)) {
      line({ class: 'grid' }, `M${x(value).toFixed(1)},${box.top}V${box.bottom}`);
      text(tickText(at.axis, value), { x: x(value), y: box.bottom + 16, 'text-anchor': 'middle' });
    }
    line({ class: 'border' }, `M${box.left},${box.top}V${box.bottom}H${box.right}`);
    const unit = hasUnit(quantity.unit) ? ' [' + quantity.unit + ']' : '';
    const name = at.axis === 'time' ? 'time' : at.axis === 'evaluations' ? counted(methods)
      : at.knob + (at.knob === 'step' && context.timeUnit ? ' [' + context.timeUnit + ']' : '');
    text(name, { x: (box.left + box.right) / 2, y: box.bottom + 36, 'text-anchor': 'middle', class: 'name' });
    text('error' + unit, { class: 'name', 'text-anchor': 'middle', transform: `translate(12,${(box.top + box.bottom) / 2})rotate(-90)` });
    if (at.strip) {
      line({ class: 'border' }, `M${box.left},${box.top - 4}H${box.right}`);
      text('no number, or off the scale', { x: box.left, y: box.top - 32, class: 'small' });
    }
    const across = (value, kind, says) => {
      const height = y(value);
      if (!(height >= box.top && height <= box.bottom)) return;
      line({ class: 'level ' + kind }, `M${box.left},${height.toFixed(1)}H${box.right}`);
      const wide = widthOf(says, '11px ' + context.font());
      const name = narrow ? { left: box.right - 3 - wide, right: box.right - 3, top: height - 15, bottom: height - 1 }
        : { left: box.right + 6, right: box.right + 6 + wide, top: height - 7, bottom: height + 7 };
      for (const other of obstacles)
        if (overlap(name, other)) [name.top, name.bottom] = [other.bottom, other.bottom + 14];
      text(says, { x: name.left, y: name.bottom - 3, class: 'level-name' });
      obstacles.push(name);
    };
    if (quantity.need > 0)
      across(quantity.need, 'need', quantity.asked ? 'asked: ' + quantity.asked
        : 'needed: ' + inUnit(quantity.need, quantity.unit.length > 6 ? '' : quantity.unit));
    for (const { error, says } of [...(context.close || [])].sort((a, b) => b.error - a.error)) across(error, 'close', 'for a game: ' + says);
    if (at.floored) across(quantity.floor, 'floor', narrow ? 'truth known to here' : 'truth known');
    return group;
  }

  function labels(curves, obstacles, view, context, bounds, narrow) {
    const group = svg('g', { class: 'labels', 'aria-hidden': 'true' });
    if (view.every && curves.length > mostCurves) return group;
    const names = namesOf(curves.map((c) => c.method));
    const font = '600 12px ' + context.font();
    curves.forEach((c, i) => {
      c.name = narrow ? shortened(names[i], 24) : names[i];
      c.width = widthOf(c.name, font);
    });
    for (const label of placeLabels(curves, bounds, obstacles)) {
      const { spot } = label, left = label.left > spot.x;
      const far = label.bottom < spot.y - 12 || label.top > spot.y + 12;
      if (far) group.append(svg('path', { class: 'leader', style: '--c: ' + colourOf(label.curve.method, view.by),
        d: `M${spot.x.toFixed(1)},${spot.y.toFixed(1)}L${(left ? label.left : label.right).toFixed(1)},${(label.top + 8).toFixed(1)}` }));
      group.append(svg('text', { x: label.left.toFixed(1), y: (label.bottom - 4).toFixed(1),
        style: '--c: ' + colourOf(label.curve.method, view.by) }, label.curve.name));
    }
    return group;
  }

  /** Where there is no curve to draw: a row a method, its errors from exact on the left to far on the right. */
  function rows(quantity, methods, view, context, width) {
    const narrow = width < 560, tall = narrow ? 40 : 24;
    const names = methods.map((m) => shortened(named(m), narrow ? 48 : 60));
    const font = '12px ' + context.font();
    const edge = narrow ? 10 : 16 + Math.max(...names.map((name) => widthOf(name, font)), 40);
    const points = methods.flatMap((m) => m.points);
    const errors = points.map((p) => p.error).filter((e) => e > 0).concat(quantity.need > 0 ? [quantity.need] : []);
    const range = decades(errors.length ? errors : [1]);
    const box = { left: edge + 84, right: width - 64, top: narrow ? 34 : 26, bottom: (narrow ? 38 : 30) + tall * methods.length };
    const x = (error) => error === null ? width - 26 : error === 0 ? edge + 24
      : box.left + (box.right - box.left) * part(range, error);
    const height = box.bottom + 42;
    const picture = svg('svg', { class: 'work-precision rows', viewBox: `0 0 ${width} ${height}`, width, height, role: 'group' });
    const back = svg('g', { class: 'axes', 'aria-hidden': 'true' });
    const text = (says, attributes) => back.append(svg('text', attributes, says));
    for (const value of ticks(range, narrow ? 4 : 9)) {
      back.append(svg('path', { class: 'grid', d: `M${x(value).toFixed(1)},${box.top}V${box.bottom}` }));
      text(tickText('error', value), { x: x(value), y: box.bottom + 16, 'text-anchor': 'middle' });
    }
    text('exact', { x: x(0), y: box.bottom + 16, 'text-anchor': 'middle' });
    if (points.some((p) => p.error === null)) text('no number', { x: width - 2, y: box.bottom + 16, 'text-anchor': 'end' });
    text('error' + (hasUnit(quantity.unit) ? ' [' + quantity.unit + ']' : ''),
      { x: (box.left + box.right) / 2, y: box.bottom + 36, 'text-anchor': 'middle', class: 'name' });
    if (quantity.need > 0) {
      back.append(svg('path', { class: 'level need', d: `M${x(quantity.need).toFixed(1)},${box.top - 6}V${box.bottom}` }));
      const says = 'needed: ' + inUnit(quantity.need, quantity.unit), half = widthOf(says, '11px ' + context.font()) / 2;
      text(says, { x: Math.min(x(quantity.need), width - half - 2), y: box.top - 10, 'text-anchor': 'middle', class: 'level-name' });
    }
    picture.append(back);
    const spots = [];
    methods.forEach((m, i) => {
      const y = box.top + 4 + tall * (i + (narrow ? 0.7 : 0.5));
      back.append(svg('path', { class: 'grid', d: `M${edge},${y}H${width}` }));
      text(names[i], narrow ? { x: 4, y: y - 12 } : { x: edge - 8, y: y + 4, 'text-anchor': 'end' });
      const curve = svg('g', { class: 'curve' });
      curve.style.setProperty('--c', colourOf(m, view.by));
      for (const p of m.points) {
        const spot = { point: p, x: x(p.error), y, node: nodeOf(p, quantity, context, false), curve };
        spot.node.setAttribute('transform', `translate(${spot.x.toFixed(1)},${y})`);
        curve.append(spot.node);
        spots.push(spot);
      }
      picture.append(curve);
    });
    return { svg: picture, spots };
  }

  // ---- the page --------------------------------------------------------------------------------------------

  /** What charts, tables and maps of a quantity share. */
  function contextOf(data, quantity) {
    const motion = data.scene && data.quantities[data.scene.quantity] === quantity;
    const close = motion ? Object.entries(data.scene.close).map(([unit, error]) => ({ error, says: needOfGame(error, unit) })) : [];
    return {
      styles: data.styles, outcomes: data.outcomes, close, plays: motion,
      timeUnit: data.scene ? data.scene.time_unit : '',
      game: close.length ? { error: Math.min(...close.map((c) => c.error)), says: close.map((c) => c.says).join(' and ') } : null,
    };
  }

  /** Acts when the element is about to be seen, so that a page of many charts is there at once. */
  function whenNear(place, act) {
    const observer = new IntersectionObserver((entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      observer.disconnect();
      act();
    }, { rootMargin: '800px' });
    observer.observe(place);
  }

  const quantityNamed = (name) => oddity.data.quantities.find((q) => q.name === name);

  function start() {
    if (!oddity.data) return;
    for (const figure of document.querySelectorAll('figure.chart[data-quantity]')) {
      const quantity = quantityNamed(figure.dataset.quantity);
      if (quantity) whenNear(figure, () => chart(figure, quantity, contextOf(oddity.data, quantity)));
    }
  }

  oddity.charts = {
    number, count, duration, inUnit, needOfGame, median, power,
    families, colourOf, methodsOf, front, highlighted, frame, ticks, part, finding, findingOfRows, description, settingOf, mainKnob,
    placeLabels, way, namesOf, named, called, cost, usable, lettered, shortened,
    element, svg, mark, swatch, choice, chart, contextOf, quantityNamed, said, play, detailOf, isPoint, isOf,
    whenNear,
    whenReady(run) {
      if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', run);
      else run();
    },
  };
  if (typeof document !== 'undefined') oddity.charts.whenReady(start);
})(window.oddity = window.oddity || {});
