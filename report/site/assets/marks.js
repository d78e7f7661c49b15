// Parts of charts: elements, the marks of algorithms, and labels that do not overlap.
(function (oddity) {
  'use strict';

  const { called } = oddity.charts;

  // ---- elements --------------------------------------------------------------------------------------------

  function element(name, attributes = {}, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes))
      if (value !== undefined) made.setAttribute(key, value);
    made.append(...children);
    return made;
  }

  function svg(name, attributes = {}, ...children) {
    const made = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes))
      if (key.startsWith('--')) made.style.setProperty(key, value);
      else made.setAttribute(key, value);
    made.append(...children);
    return made;
  }

  const shapes = [
    (r) => `M${-r},0a${r},${r} 0 1,0 ${2 * r},0a${r},${r} 0 1,0 ${-2 * r},0z`,
    (r) => `M${-r * 0.9},${-r * 0.9}h${r * 1.8}v${r * 1.8}h${-r * 1.8}z`,
    (r) => `M0,${-r * 1.2}L${r * 1.15},${r * 0.8}H${-r * 1.15}z`,
    (r) => `M0,${r * 1.2}L${r * 1.15},${-r * 0.8}H${-r * 1.15}z`,
    (r) => `M0,${-r * 1.35}L${r * 1.1},0L0,${r * 1.35}L${-r * 1.1},0z`,
    (r) =>
      'M' +
      [0, 1, 2, 3, 4]
        .map((i) =>
          [1.2 * r * Math.sin(i * 0.4 * Math.PI), -1.2 * r * Math.cos(i * 0.4 * Math.PI)]
            .map((x) => x.toFixed(2))
            .join(','),
        )
        .join('L') +
      'z',
  ];

  /** An algorithm's mark: a shape, filled or open; those after the first twelve contain a dot or a bar. */
  function mark(place, r = 4) {
    const kind = Math.floor(place / 12) % 3,
      open = place % 12 >= 6;
    const group = svg('g', { class: 'mark' + (open ? ' open' : '') });
    group.append(svg('path', { d: shapes[place % 6](r), class: 'shape' }));
    if (kind === 1) group.append(svg('circle', { r: r * 0.4, class: 'inner' }));
    if (kind === 2) group.append(svg('path', { d: `M${-r * 1.5},0H${r * 1.5}`, class: 'bar' }));
    return group;
  }

  function swatch(...drawn) {
    return svg(
      'svg',
      { class: 'swatch', viewBox: '-8 -8 16 16', width: 16, height: 16, 'aria-hidden': 'true' },
      ...drawn,
    );
  }

  let pen = null;
  function widthOf(text, font) {
    if (!pen) pen = document.createElement('canvas').getContext('2d');
    pen.font = font;
    return pen.measureText(text).width;
  }

  /** A row of buttons, one of which is pressed. */
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

  const overlap = (a, b) =>
    Math.max(0, Math.min(a.right, b.right) - Math.max(a.left, b.left)) *
    Math.max(0, Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));

  /** Places for a label of this width next to a point. */
  function beside(spot, width, height) {
    const middle = { top: spot.y - height / 2, bottom: spot.y + height / 2 };
    const box = (left, top) => ({ left, right: left + width, top, bottom: top + height });
    return [
      { left: spot.x + 9, right: spot.x + 9 + width, ...middle },
      { left: spot.x - 9 - width, right: spot.x - 9, ...middle },
      box(spot.x + 6, spot.y - height - 5),
      box(spot.x + 6, spot.y + 5),
      box(spot.x - 6 - width, spot.y - height - 5),
      box(spot.x - 6 - width, spot.y + 5),
      box(spot.x - width / 2, spot.y - height - 8),
      box(spot.x - width / 2, spot.y + 8),
      ...[24, 40, 56].flatMap((away) => [
        box(spot.x + 12, spot.y - height - away),
        box(spot.x - 12 - width, spot.y - height - away),
        box(spot.x + 12, spot.y + away),
        box(spot.x - 12 - width, spot.y + away),
      ]),
    ];
  }

  /** Positions of labels: at an end of their curves, or as near to it as possible without covering anything.
      */
  function placeLabels(curves, bounds, obstacles = [], height = 15) {
    const dots = curves.flatMap((c) => c.way.map((spot) => ({ ...spot, curve: c })));
    const placed = [...obstacles];
    for (const curve of curves) {
      let least = Infinity,
        found = null;
      curve.spots.forEach((spot, i) => {
        const away = 4 * Math.min(curve.spots.length - 1 - i, i + 1);
        for (const [k, box] of beside(spot, curve.width, height).entries()) {
          const outside =
            box.left < bounds.left ||
            box.right > bounds.right ||
            box.top < bounds.top ||
            box.bottom > bounds.bottom;
          const covered = dots.filter(
            (d) => d.x > box.left - 3 && d.x < box.right + 3 && d.y > box.top - 2 && d.y < box.bottom + 2,
          );
          const price =
            (outside ? 1e4 : 0) +
            20 * placed.reduce((sum, other) => sum + overlap(box, other), 0) +
            6 * covered.length +
            away +
            (k < 8 ? 0.3 * k : k);
          if (price < least) [least, found] = [price, { ...box, curve, spot }];
        }
      });
      if (found) placed.push(found);
    }
    return placed.slice(obstacles.length);
  }

  /** The path of a curve, a spot every few pixels. */
  function way(spots, every = 7) {
    const all = [];
    spots.forEach((spot, i) => {
      const next = spots[i + 1] || spot;
      const parts = Math.max(1, Math.round(Math.hypot(next.x - spot.x, next.y - spot.y) / every));
      for (let k = 0; k < parts; ++k)
        all.push({
          x: spot.x + ((next.x - spot.x) * k) / parts,
          y: spot.y + ((next.y - spot.y) * k) / parts,
        });
    });
    return all;
  }

  const shortened = (text, most) => (text.length <= most ? text : text.slice(0, most - 1).trimEnd() + '…');

  /** The shortest distinct names of curves. */
  function namesOf(methods) {
    const short = methods.map((m) => called(m, false));
    return methods.map(
      (m, i) =>
        shortened(short[i], 34) +
        (short.filter((other) => other === short[i]).length > 1 ? ', ' + shortened(m.model, 22) : ''),
    );
  }

  Object.assign(oddity.charts, {
    element,
    svg,
    mark,
    swatch,
    widthOf,
    choice,
    overlap,
    placeLabels,
    way,
    shortened,
    namesOf,
  });
})((window.oddity = window.oddity || {}));
