// Evaluates a quantity's trials: its methods and points, the Pareto front, the axes, the curves worth
// showing, and the finding in a sentence. Independent of the page.
(function (oddity) {
  'use strict';

  // ---- numbers ---------------------------------------------------------------------------------------------

  const superscripts = {
    '-': '⁻',
    0: '⁰',
    1: '¹',
    2: '²',
    3: '³',
    4: '⁴',
    5: '⁵',
    6: '⁶',
    7: '⁷',
    8: '⁸',
    9: '⁹',
  };
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
    const units = [
      [1e9, 's'],
      [1e6, 'ms'],
      [1e3, 'µs'],
      [1, 'ns'],
    ];
    const [size, unit] = units.find(([least]) => ns >= least) || [1, 'ns'];
    return number(ns / size, digits) + ' ' + unit;
  }

  const hasUnit = (unit) => unit && unit !== '1' && !unit.includes(',');
  const inUnit = (x, unit, digits) => number(x, digits) + (hasUnit(unit) && x !== null ? ' ' + unit : '');

  /** "error [rad]". */
  const errorName = (unit) => 'error' + (hasUnit(unit) ? ' [' + unit + ']' : ' (dimensionless)');

  /** A game's tolerance in usual units: "1 cm", "1°". */
  function needOfGame(value, unit) {
    if (unit === 'm' && value === 0.01) return '1 cm';
    if (unit === 'rad' && Math.abs((value * 180) / Math.PI - 1) < 1e-3) return '1°';
    return inUnit(value, unit);
  }

  // ---- a quantity's methods and points
  // ---------------------------------------------------------------------

  /** Families of algorithms that integrate a motion, in the order of their colours. */
  const families = [
    'closed form',
    'explicit steps',
    'partitioned',
    'step control',
    'extrapolation',
    'multistep',
    'implicit',
    'series',
  ];
  const familyOf = (name) => (families.includes(name) ? families.indexOf(name) : families.length);
  const colourOf = (m, by) => `var(--${by}-${m.colours[by]})`;

  const failures = new Set(['X', 'N', 'S', 'R', 'C', 'G']);
  /** Outcomes that are shown as a letter at the point; `inaccurate` is visible from the line of the need. */
  const lettered = (outcome) => outcome !== 'o' && outcome !== 'i';

  /** The methods of a quantity, with their indices in the palettes and their trials as points. */
  function methodsOf(quantity, styles) {
    return quantity.methods.map((m, index) => {
      const method = {
        model: m.model,
        algorithm: m.algorithm,
        precision: m.precision,
        resolution: m.resolution,
        index,
        family: styles.families[m.algorithm] || m.algorithm,
        colours: {
          model: (styles.colours[m.model] || 0) % 11,
          family: familyOf(styles.families[m.algorithm]),
        },
        mark: styles.marks[m.algorithm] || 0,
      };
      method.points = m.trials.map(([setting, error, evaluations, ns, spread, outcome], place) => ({
        method,
        place,
        setting,
        error,
        evaluations,
        ns,
        spread,
        outcome,
      }));
      return method;
    });
  }

  const pointsOf = (methods) => methods.flatMap((m) => m.points);
  const usable = (p) => !failures.has(p.outcome) && p.error !== null;
  const cost = (p, axis) => (axis === 'time' ? p.ns : Math.max(p.evaluations, 1));
  const named = (m) => m.algorithm + (m.precision === 'float' ? ' in float' : '') + ' (' + m.model + ')';

  /** The method's name in a sentence. */
  const spoken = (m) =>
    m.algorithm === 'closed form'
      ? m.model + ' in closed form' + (m.precision === 'float' ? ' in float' : '')
      : named(m);
  /** Capitalizes a sentence, unless it begins with a letter or a function's name. */
  const sentence = (text) => (/^[a-z]{2,}[ ,-]/.test(text) ? text[0].toUpperCase() + text.slice(1) : text);

  /** A short name: the algorithm, or the model of a closed form. */
  function called(m, withModel) {
    const name = m.algorithm === 'closed form' ? m.model : m.algorithm;
    return (
      name +
      (m.precision === 'float' ? ' in float' : '') +
      (withModel && m.algorithm !== 'closed form' ? ' (' + m.model + ')' : '')
    );
  }

  /** The points that no other beats: none is at most as large in both cost and error, and smaller in one of
      them. */
  function front(points, axis, floor) {
    const able = points.filter((p) => usable(p) && cost(p, axis) !== null && !Number.isNaN(cost(p, axis)));
    const error = (p) => Math.max(p.error, floor);
    able.sort((a, b) => cost(a, axis) - cost(b, axis) || error(a) - error(b));
    let least = Infinity,
      at = NaN;
    return able.filter((p) => {
      const tie = cost(p, axis) === at && error(p) === least;
      if (!tie && error(p) >= least) return false;
      least = error(p);
      at = cost(p, axis);
      return true;
    });
  }

  /** Whether a is the better point: ok and cheaper, otherwise nearer to the truth. */
  function preferable(a, b, axis) {
    if ((a.outcome === 'o') !== (b.outcome === 'o')) return a.outcome === 'o';
    if (a.outcome !== 'o') return a.error !== null && (b.error === null || a.error < b.error);
    return cost(a, axis) !== cost(b, axis) ? cost(a, axis) < cost(b, axis) : a.error < b.error;
  }

  const best = (points, axis) => points.reduce((a, b) => (preferable(b, a, axis) ? b : a));

  /** The setting on the axis: that of most methods; a tolerance only if there is no other. */
  function mainResolution(methods) {
    const counts = {};
    for (const m of methods) if (m.resolution) counts[m.resolution] = (counts[m.resolution] || 0) + 1;
    const resolutions = Object.keys(counts).sort((a, b) => counts[b] - counts[a]);
    return resolutions.find((resolution) => resolution !== 'tolerance') || resolutions[0] || '';
  }

  // ---- axes
  // ------------------------------------------------------------------------------------------------

  const decadeBelow = (x) => Math.floor(Math.log10(x) + 1e-9);
  const decadeAbove = (x) => Math.ceil(Math.log10(x) - 1e-9);

  function decades(numbers) {
    if (!numbers.length) return { low: 0, high: 1, log: true };
    const low = decadeBelow(Math.min(...numbers));
    return { low, high: Math.max(decadeAbove(Math.max(...numbers)), low + 1), log: true };
  }

  /** The ranges of both axes, as exponents of ten if logarithmic, and the place of each point. */
  function frame(quantity, methods, axis) {
    const resolution = mainResolution(methods);
    const isLine = (m) => axis === 'setting' && !m.resolution;
    const abscissa = (p) =>
      axis !== 'setting' ? cost(p, axis) : p.method.resolution === resolution ? p.setting : isLine(p.method) ? edge : NaN;
    let edge = 1; // place of the point, and start of the line, of a method without a setting
    const top = Math.max(1e3 * quantity.size, 10 * quantity.need) || 1;
    const points = pointsOf(methods);
    const errors = points.map((p) => p.error).filter((e) => e > 0 && e <= top);
    // A zero error is drawn a decade below the smallest one, or at the floor.
    const least = Math.max(
      quantity.floor,
      errors.length
        ? Math.min(...errors.filter((e) => e >= quantity.floor), quantity.need || Infinity) / 10
        : 0,
    );
    const within = (p) => p.error !== null && p.error <= top;
    const shown = points.filter((p) => abscissa(p) > 0);
    const seen = shown.filter(within).map((p) => Math.max(p.error, least));
    const xs = shown.filter((p) => !isLine(p.method)).map(abscissa);
    const few = axis === 'setting' && Math.min(...xs) >= 1 && Math.max(...xs) < 100;
    const x = few ? { low: Math.min(...xs) - 1, high: Math.max(...xs) + 1, log: false } : decades(xs);
    edge = few ? x.low : Math.pow(10, x.low);
    return {
      axis,
      resolution,
      abscissa,
      within,
      isLine,
      x,
      y: decades(seen.concat(quantity.need > 0 ? [quantity.need] : [])),
      ordinate: (p) => Math.max(p.error, least),
      strip: shown.some((p) => !within(p)),
      floored: shown.some((p) => p.error !== null && p.error < quantity.floor),
      shows: (m) => m.points.some((p) => abscissa(p) > 0),
    };
  }

  const part = (range, value) =>
    ((range.log ? Math.log10(value) : value) - range.low) / (range.high - range.low);

  /** Decades for ticks, at most `most` of them; whole numbers where the axis is linear. */
  function ticks(range, most) {
    const every = Math.max(1, Math.ceil((range.high - range.low) / most));
    const all = [];
    for (let at = Math.ceil(range.low); at <= range.high; ++at)
      if ((at - Math.ceil(range.low)) % every === 0) all.push(range.log ? Math.pow(10, at) : at);
    return all;
  }

  // ---- curves worth showing
  // --------------------------------------------------------------------------------

  const mostCurves = 8;

  /** The methods that are coloured at first: those of the title, on the Pareto front, and the best of each
      family. */
  function highlighted(methods, at, floor, spokenOf = []) {
    if (methods.length <= mostCurves) return new Set(methods);
    const chosen = new Set(spokenOf.filter((m) => methods.includes(m))),
      alike = [];
    const lookAlike = (p, q) =>
      Math.abs(Math.log10(at.abscissa(p) / at.abscissa(q))) < 0.05 &&
      Math.abs(Math.log10(at.ordinate(p) / at.ordinate(q))) < 0.3;
    if (at.axis !== 'setting')
      for (const p of front(pointsOf(methods), at.axis, floor)) {
        if (alike.some((q) => lookAlike(p, q))) continue;
        alike.push(p);
        if (chosen.size < mostCurves) chosen.add(p.method);
      }
    const families = new Map();
    for (const m of methods) {
      const mine = best(m.points, at.axis),
        other = families.get(m.family);
      if (!other || preferable(mine, other, at.axis)) families.set(m.family, mine);
    }
    const ranked = [...families.values()].sort((a, b) => (preferable(a, b, at.axis) ? -1 : 1));
    for (const p of ranked) if (chosen.size < mostCurves) chosen.add(p.method);
    return chosen;
  }

  // ---- findings
  // ---------------------------------------------------------------------------------------------

  const work = (p, axis) =>
    axis === 'time'
      ? duration(p.ns)
      : count(p.evaluations) + (p.evaluations === 1 ? ' evaluation' : ' evaluations');

  function cheapest(methods, axis, allowed) {
    const points = pointsOf(methods).filter(
      (p) => usable(p) && p.error <= allowed && cost(p, axis) !== null,
    );
    return points.length
      ? points.reduce((a, b) =>
          cost(b, axis) < cost(a, axis) || (cost(b, axis) === cost(a, axis) && b.error < a.error) ? b : a,
        )
      : null;
  }

  const integrates = (m) => m.resolution === 'step' || m.resolution === 'tolerance';

  /** The finding for a motion at a game's tolerance: "velocity Verlet needs 80 evaluations, 32 times fewer
      than explicit Euler". */
  function findingOfMotion(methods, axis, game) {
    const integrators = methods.filter(integrates),
      closed = methods.filter((m) => !integrates(m));
    const several = new Set(integrators.map((m) => m.model)).size > 1;
    const within = 'Within ' + game.says + ', ';
    const least = cheapest(integrators, axis, game.error),
      exact = cheapest(closed, axis, game.error);
    const known = !exact
      ? ''
      : exact.method.model +
        (exact.method.algorithm === 'closed form' ? ' in closed form' : ' by ' + exact.method.algorithm) +
        ' needs ' +
        work(exact, axis);
    if (!least)
      return {
        says: exact
          ? within + known + '; no integrator comes there.'
          : 'No method stays within ' + game.says + '.',
        of: exact ? [exact.method] : [],
      };
    const plain = cheapest(
      integrators.filter((m) => m.algorithm === 'explicit Euler'),
      axis,
      game.error,
    );
    const said = called(least.method, several) + ' needs ' + work(least, axis);
    const many = plain ? cost(plain, axis) / cost(least, axis) : NaN;
    const beside =
      least.method.algorithm === 'explicit Euler'
        ? ', the least of all integrators'
        : many >= 1.2
          ? ', ' + number(many) + ' times ' + (axis === 'time' ? 'less' : 'fewer') + ' than explicit Euler'
          : !plain && integrators.some((m) => m.algorithm === 'explicit Euler')
            ? '; explicit Euler does not come there'
            : '';
    const cheaper = exact && cost(exact, axis) < cost(least, axis);
    return {
      says: within + said + beside + (cheaper ? '; ' + known : '') + '.',
      of: [least, plain, cheaper ? exact : null].filter(Boolean).map((p) => p.method),
    };
  }

  /** The finding for answers that are right or wrong, or for one point per method. */
  function findingOfRows(methods) {
    const right = methods.filter((m) => m.points[m.points.length - 1].outcome === 'o');
    const all = count(methods.length);
    const finest = right.some((m) => m.points.some((p) => p.outcome !== 'o'))
      ? ' at their finest setting.'
      : '.';
    if (methods.length === 1)
      return named(methods[0]) + ' is ' + (right.length ? '' : 'not ') + 'as exact as needed' + finest;
    if (!right.length) return 'None of ' + all + ' methods is as exact as needed.';
    if (right.length === methods.length)
      return (right.length === 2 ? 'Both' : 'All ' + all) + ' methods are as exact as needed' + finest;
    const wrong = methods.filter((m) => !right.includes(m));
    const few = (list) => (list.length <= 2 ? list.map(named).join(' and ') : count(list.length));
    return right.length <= wrong.length
      ? 'Only ' +
          few(right) +
          ' of ' +
          all +
          ' methods ' +
          (right.length === 1 ? 'is' : 'are') +
          ' as exact as needed.'
      : few(right) + ' of ' + all + ' methods are as exact as needed; not ' + few(wrong) + '.';
  }

  /** A chart's finding and its methods: `{says, of}`. */
  function finding(quantity, methods, axis, game) {
    if (!methods.length) return { says: 'Nothing is shown.', of: [] };
    if (!axis) return { says: findingOfRows(methods), of: [] };
    if (axis === 'setting') return findingOfSettings(quantity, methods);
    if (game) return findingOfMotion(methods, axis, game);
    return findingOfWork(quantity, methods, axis);
  }

  function findingOfSettings(quantity, methods) {
    const resolution = mainResolution(methods),
      setting = /^(step|tolerance|distance|pulse|softness|amplitude)$/.test(resolution)
        ? 'a ' + resolution
        : 'the setting "' + resolution + '"';
    const points = pointsOf(methods.filter((m) => m.resolution === resolution)).filter(usable);
    if (!points.length) return { says: 'No method with ' + setting + ' comes to its end.', of: [] };
    const least = points.reduce((a, b) => (b.error < a.error ? b : a));
    return {
      says:
        spoken(least.method) +
        ' is the most accurate of the methods with ' +
        setting +
        ': ' +
        inUnit(least.error, quantity.unit) +
        ' at ' +
        number(least.setting, 3) +
        '.',
      of: [least.method],
    };
  }

  function findingOfWork(quantity, methods, axis) {
    const needed = quantity.asked || inUnit(quantity.need, quantity.unit);
    const least = cheapest(methods, axis, quantity.need);
    if (!least) {
      const points = pointsOf(methods).filter(usable);
      if (!points.length) return { says: 'No method comes to an end.', of: [] };
      const nearest = points.reduce((a, b) => (b.error < a.error ? b : a));
      return {
        says:
          'No method reaches ' +
          needed +
          '; the closest is ' +
          spoken(nearest.method) +
          ': ' +
          inUnit(nearest.error, quantity.unit) +
          '.',
        of: [nearest.method],
      };
    }
    const others = methods.filter((m) => m.family !== least.method.family || m.model !== least.method.model);
    const next = cheapest(others, axis, quantity.need);
    const many = next ? cost(next, axis) / cost(least, axis) : 0;
    return {
      says:
        spoken(least.method) +
        ' reaches ' +
        needed +
        (axis === 'time' ? ' in the least time measured: ' : ' with the least counted work: ') +
        work(least, axis) +
        (many >= 1.5 ? '; ' + spoken(next.method) + ' needs ' + number(many) + ' times as much' : '') +
        '.',
      of: many >= 1.5 ? [least.method, next.method] : [least.method],
    };
  }

  function settingOf(p, timeUnit) {
    const { resolution } = p.method;
    if (!resolution) return '';
    return resolution + ' ' + number(p.setting, 3) + (resolution === 'step' && timeUnit ? ' ' + timeUnit : '');
  }

  /** Everything known about a trial, in lines. */
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

  /** Whether a model contains the book's errors, judged by its name. */
  oddity.isPublished = (model) => /as (printed|published|proposed)|^published|printed listing/.test(model);

  oddity.charts = Object.assign(oddity.charts || {}, {
    power,
    number,
    count,
    duration,
    hasUnit,
    inUnit,
    errorName,
    needOfGame,
    families,
    colourOf,
    lettered,
    methodsOf,
    pointsOf,
    named,
    sentence,
    called,
    front,
    best,
    mainResolution,
    decades,
    frame,
    part,
    ticks,
    mostCurves,
    highlighted,
    finding,
    description,
  });
})((window.oddity = window.oddity || {}));
