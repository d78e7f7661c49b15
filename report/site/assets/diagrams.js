// The two drawings of a quantity: error against work or setting, and one row per method if there is no curve.
// The SVG is made here, without a library: each point is an element that can be focused, names its trial and
// plays it.
(function (oddity) {
  'use strict';

  const {
    power,
    number,
    duration,
    inUnit,
    errorName,
    colourOf,
    lettered,
    pointsOf,
    named,
    front,
    decades,
    frame,
    part,
    ticks,
    mostCurves,
    highlighted,
    description,
    svg,
    mark,
    widthOf,
    overlap,
    placeLabels,
    way,
    shortened,
    namesOf,
  } = oddity.charts;

  // ---- its drawings ----------------------------------------------------------------------------------------

  /** The unit of work, as far as the settings show it. */
  function counted(quantity, methods) {
    if (quantity.operations) return 'multiplications, divisions and functions';
    const differs = methods.some((m) => m.algorithm.includes('difference'));
    const steps = methods.some((m) => m.resolution === 'step');
    const nodes = methods.some((m) => m.resolution === 'panels' || m.resolution === 'points');
    if (differs) return 'evaluations of the function';
    if (steps && nodes) return 'evaluations of the right-hand side or integrand';
    if (steps) return 'evaluations of the right-hand side';
    return nodes ? 'evaluations of the integrand' : 'evaluations';
  }

  const canvas = (kind, width, height) =>
    svg('svg', { class: kind, viewBox: `0 0 ${width} ${height}`, width, height, role: 'group' });

  /** A point as an element: a dot if pale, a letter if it has no number. */
  function nodeOf(p, quantity, context, pale, inStrip) {
    const node = svg('g', {
      class: 'point' + (pale ? ' pale' : ''),
      tabindex: -1,
      role: context.plays ? 'button' : 'img',
      'aria-label': description(p, quantity, context).join(', ') + (context.plays ? '; Enter plays it' : ''),
    });
    node.append(svg('circle', { class: 'halo', r: 9 }));
    if (inStrip) node.append(svg('text', { class: 'letter', y: 4, 'text-anchor': 'middle' }, p.outcome));
    else node.append(pale ? svg('circle', { class: 'dot', r: 2 }) : mark(p.method.mark));
    if (!inStrip && !pale && lettered(p.outcome))
      node.append(svg('text', { class: 'letter', x: 6, y: -4 }, p.outcome));
    return node;
  }

  function tickText(axis, value) {
    if (axis === 'time') return duration(value, 1);
    if (value >= 0.01 && value < 1e4) return number(value, 3);
    return power(Math.round(Math.log10(value)));
  }

  /** Error against evaluations, time or the setting, both axes logarithmic. */
  function workPrecision(quantity, methods, spokenOf, view, context, width) {
    const narrow = width < 560;
    const at = frame(quantity, methods, view.axis);
    const box = {
      left: narrow ? 46 : 62,
      right: width - (narrow ? 10 : 150),
      top: at.strip ? 46 : 14,
      bottom: 0,
    };
    const height = Math.round(Math.max(narrow ? 360 : 400, Math.min(520, width * 0.55)));
    box.bottom = height - 46;
    const x = (value) => box.left + (box.right - box.left) * part(at.x, value);
    const y = (value) => box.bottom - (box.bottom - box.top) * part(at.y, value);
    const spotOf = (p) => ({
      point: p,
      x: Math.max(box.left, x(at.abscissa(p))),
      y: at.within(p) ? y(at.ordinate(p)) : box.top - 17,
    });
    const drawn = methods.filter(at.shows);
    const bright = view.every ? new Set(drawn) : highlighted(drawn, at, quantity.floor, spokenOf);
    const picture = canvas('work-precision', width, height);
    const spots = [],
      curves = [],
      obstacles = [];
    picture.append(axes(at, box, x, y, quantity, methods, context, narrow, obstacles));
    const points = (m) => m.points.filter((p) => at.abscissa(p) > 0);
    const back = svg('g'),
      middle = svg('g'),
      fore = svg('g');
    for (const m of drawn) {
      const pale = !bright.has(m);
      const curve = svg('g', {
        class: 'curve' + (pale ? ' pale' : '') + (m.precision === 'float' ? ' float' : ''),
      });
      curve.style.setProperty('--c', colourOf(m, view.by));
      const mine = points(m).map(spotOf);
      const inside = mine.filter((s) => at.within(s.point));
      curve.append(
        svg('path', {
          class: 'line',
          d:
            inside.map((s, i) => (i ? 'L' : 'M') + s.x.toFixed(1) + ',' + s.y.toFixed(1)).join('') +
            (at.isLine(m) && inside.length ? 'H' + box.right : ''),
        }),
      );
      for (const s of mine) {
        s.node = nodeOf(s.point, quantity, context, pale, !at.within(s.point));
        s.node.setAttribute('transform', `translate(${s.x.toFixed(1)},${s.y.toFixed(1)})`);
        Object.assign(s, { pale, curve });
        if (view.axis === 'time' && !pale) curve.append(spreadOf(s, x));
        curve.append(s.node);
        spots.push(s);
        if (!pale && lettered(s.point.outcome))
          obstacles.push({ left: s.x + 5, right: s.x + 14, top: s.y - 14, bottom: s.y - 3 });
      }
      (pale ? back : fore).append(curve);
      if (!pale && mine.length)
        curves.push({ method: m, spots: inside.length ? inside : mine, way: way(inside) });
    }
    if (view.axis !== 'setting') middle.append(frontLine(methods, view.axis, quantity.floor, spots, box));
    picture.append(
      back,
      middle,
      fore,
      labels(
        curves,
        obstacles,
        view,
        context,
        { left: box.left + 2, right: width - 2, top: 4, bottom: box.bottom - 2 },
        narrow,
      ),
    );
    const first = front(pointsOf(methods), view.axis, quantity.floor)[0];
    const start = spots.find((s) => s.point === first);
    if (start) start.first = true;
    return { svg: picture, spots };
  }

  function spreadOf(spot, x) {
    const { ns, spread } = spot.point;
    const low = x(Math.max(ns - spread, ns / 2)),
      high = x(ns + spread);
    return svg('path', {
      class: 'spread',
      d: spread && high - low > 2 ? `M${low.toFixed(1)},${spot.y.toFixed(1)}H${high.toFixed(1)}` : 'M0,0',
    });
  }

  function frontLine(methods, axis, floor, spots, box) {
    const best = new Set(front(pointsOf(methods), axis, floor));
    const steps = spots.filter((s) => best.has(s.point)).sort((a, b) => a.x - b.x || b.y - a.y);
    if (!steps.length) return '';
    const d = steps
      .map((s, i) => (i ? `H${s.x.toFixed(1)}V${s.y.toFixed(1)}` : `M${s.x.toFixed(1)},${s.y.toFixed(1)}`))
      .join('');
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
    const name =
      at.axis === 'time'
        ? 'time'
        : at.axis === 'evaluations'
          ? counted(quantity, methods)
          : at.resolution + (at.resolution === 'step' && context.timeUnit ? ' [' + context.timeUnit + ']' : '');
    text(name, { x: (box.left + box.right) / 2, y: box.bottom + 36, 'text-anchor': 'middle', class: 'name' });
    text(errorName(quantity.unit), {
      class: 'name',
      'text-anchor': 'middle',
      transform: `translate(12,${(box.top + box.bottom) / 2})rotate(-90)`,
    });
    if (at.strip) {
      line({ class: 'border' }, `M${box.left},${box.top - 4}H${box.right}`);
      text('no number, or off the scale', { x: box.left, y: box.top - 32, class: 'small' });
    }
    const across = (value, kind, says) => {
      const height = y(value);
      if (!(height >= box.top && height <= box.bottom)) return;
      line({ class: 'level ' + kind }, `M${box.left},${height.toFixed(1)}H${box.right}`);
      const wide = widthOf(says, '11px ' + context.font());
      const name = narrow
        ? { left: box.right - 3 - wide, right: box.right - 3, top: height - 15, bottom: height - 1 }
        : { left: box.right + 6, right: box.right + 6 + wide, top: height - 7, bottom: height + 7 };
      for (const other of obstacles)
        if (overlap(name, other)) [name.top, name.bottom] = [other.bottom, other.bottom + 14];
      text(says, { x: name.left, y: name.bottom - 3, class: 'level-name' });
      obstacles.push(name);
    };
    if (quantity.need > 0)
      across(
        quantity.need,
        'need',
        quantity.asked
          ? 'asked: ' + quantity.asked
          : 'needed: ' + inUnit(quantity.need, quantity.unit.length > 6 ? '' : quantity.unit),
      );
    for (const { error, says } of [...(context.close || [])].sort((a, b) => b.error - a.error))
      across(error, 'close', 'for a game: ' + says);
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
      const { spot } = label,
        left = label.left > spot.x;
      const far = label.bottom < spot.y - 12 || label.top > spot.y + 12;
      if (far)
        group.append(
          svg('path', {
            class: 'leader',
            '--c': colourOf(label.curve.method, view.by),
            d: `M${spot.x.toFixed(1)},${spot.y.toFixed(1)}L${(left ? label.left : label.right).toFixed(1)},${(label.top + 8).toFixed(1)}`,
          }),
        );
      group.append(
        svg(
          'text',
          {
            x: label.left.toFixed(1),
            y: (label.bottom - 4).toFixed(1),
            '--c': colourOf(label.curve.method, view.by),
          },
          label.curve.name,
        ),
      );
    }
    return group;
  }

  /** For quantities without a curve: one row per method, its errors from exact on the left to large on the
      right. */
  function rows(quantity, methods, view, context, width) {
    const narrow = width < 560,
      tall = narrow ? 40 : 24;
    const names = methods.map((m) => shortened(named(m), narrow ? 48 : 60));
    const font = '12px ' + context.font();
    const edge = narrow ? 10 : 16 + Math.max(...names.map((name) => widthOf(name, font)), 40);
    const points = pointsOf(methods);
    const errors = points
      .map((p) => p.error)
      .filter((e) => e > 0)
      .concat(quantity.need > 0 ? [quantity.need] : []);
    const range = decades(errors.length ? errors : [1]);
    const box = {
      left: edge + 84,
      right: width - 64,
      top: narrow ? 34 : 26,
      bottom: (narrow ? 38 : 30) + tall * methods.length,
    };
    const x = (error) =>
      error === null
        ? width - 26
        : error === 0
          ? edge + 24
          : box.left + (box.right - box.left) * part(range, error);
    const height = box.bottom + 42;
    const picture = canvas('work-precision rows', width, height);
    const back = svg('g', { class: 'axes', 'aria-hidden': 'true' });
    const text = (says, attributes) => back.append(svg('text', attributes, says));
    for (const value of ticks(range, Math.max(2, Math.min(9, Math.floor((box.right - box.left) / 50))))) {
      back.append(svg('path', { class: 'grid', d: `M${x(value).toFixed(1)},${box.top}V${box.bottom}` }));
      text(tickText('error', value), { x: x(value), y: box.bottom + 16, 'text-anchor': 'middle' });
    }
    text('exact', { x: x(0), y: box.bottom + 16, 'text-anchor': 'middle' });
    if (points.some((p) => p.error === null))
      text('no number', { x: width - 2, y: box.bottom + 16, 'text-anchor': 'end' });
    text(errorName(quantity.unit), {
      x: (box.left + box.right) / 2,
      y: box.bottom + 36,
      'text-anchor': 'middle',
      class: 'name',
    });
    if (quantity.need > 0) {
      back.append(
        svg('path', {
          class: 'level need',
          d: `M${x(quantity.need).toFixed(1)},${box.top - 6}V${box.bottom}`,
        }),
      );
      const says = 'needed: ' + inUnit(quantity.need, quantity.unit),
        half = widthOf(says, '11px ' + context.font()) / 2;
      text(says, {
        x: Math.min(x(quantity.need), width - half - 2),
        y: box.top - 10,
        'text-anchor': 'middle',
        class: 'level-name',
      });
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

  Object.assign(oddity.charts, { workPrecision, rows });
})((window.oddity = window.oddity || {}));
