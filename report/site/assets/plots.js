// The lesson's charts as drawings: position and velocity next to the true circle, and energy over time.
(function (oddity) {
  'use strict';

  function shape(name, attributes, ...children) {
    const made = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    made.append(...children);
    return made;
  }
  const line = (kind, points = '') => shape('polyline', { class: kind, points });
  const word = (x, y, text, anchor = 'start') => shape('text', { x, y, 'text-anchor': anchor }, text);
  const drawing = (width, height, label, ...parts) =>
    shape('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': label }, ...parts);
  const bounded = (x) => Math.min(5000, Math.max(-5000, x));
  const points = (all) => all.map(([x, y]) => `${bounded(x).toFixed(1)},${bounded(y).toFixed(1)}`).join(' ');

  /** {element, show({radius, way, dotted}), now(place), placeOf(event)}, in units of length, up to `reach`. */
  oddity.circlePlot = function (reach) {
    const side = 400, middle = side / 2, scale = middle / reach;
    const at = ([x, y]) => [middle + scale * x, middle - scale * y];
    const circle = shape('circle', { class: 'true', cx: middle, cy: middle, r: 0 });
    const way = line('way'), dots = shape('g', { class: 'dots' });
    const arm = line('arm'), point = shape('circle', { class: 'now', r: 6 });
    const element = drawing(side, side, 'The place against the velocity over \u03c9: the true circle, and the points of the method.',
      line('axis', `0,${middle} ${side},${middle}`), line('axis', `${middle},0 ${middle},${side}`),
      word(side - 6, middle - 8, 'place x', 'end'), word(middle + 8, 16, 'velocity / \u03c9'), circle, way, dots, arm, point);
    return {
      element,
      show(shown) {
        circle.setAttribute('r', scale * shown.radius);
        this.all = shown.way.map(at);
        this.dotted = shown.dotted;
      },
      /** The state after so many steps, and a part of the next. */
      now(steps, place) {
        const here = at(place), past = this.all.slice(0, steps + 1);
        way.setAttribute('points', points([...past, here]));
        const seen = this.dotted ? past.slice(-80) : [];
        dots.replaceChildren(...seen.map(([cx, cy]) => shape('circle', { cx: bounded(cx), cy: bounded(cy), r: 3 })));
        arm.setAttribute('points', points([[middle, middle], here]));
        point.setAttribute('cx', bounded(here[0]));
        point.setAttribute('cy', bounded(here[1]));
      },
      placeOf(event) {
        const box = element.getBoundingClientRect();
        return [(event.clientX - box.left) / box.width * 2 * reach - reach, reach - (event.clientY - box.top) / box.height * 2 * reach];
      },
    };
  };

  /** {element, show({end, energies, shadows, times}), now(steps)}: values relative to the initial ones. */
  oddity.energyPlot = function () {
    const width = 420, height = 220, left = 34, right = 410, top = 14, bottom = 192, most = 3;
    const y = (part) => bottom - (bottom - top) * Math.min(part, 1.1 * most) / most;
    const way = line('way'), shadow = line('shadow'), ended = word(right, bottom + 18, '', 'end');
    const named = word(right, bottom - 8, '', 'end');
    const element = drawing(width, height, 'The energy over time, as a part of the energy at the start.',
      shape('clipPath', { id: 'energies' }, shape('rect', { x: left, y: top, width: right - left, height: bottom - top })),
      line('axis', `${left},${top} ${left},${bottom} ${right},${bottom}`), line('true', `${left},${y(1)} ${right},${y(1)}`),
      ...[0, 1, 2, 3].map((n) => word(left - 8, y(n) + 5, String(n), 'end')), word(right, top + 2, 'energy / energy at the start', 'end'), ended, named,
      shape('g', { 'clip-path': 'url(#energies)' }, shadow, way));
    let curve = [];
    return {
      element,
      show({ end, energies, shadows, times }) {
        const x = (t) => left + (right - left) * t / end;
        const of = (values) => values.map((value, k) => [x(times[k]), y(value / values[0])]);
        curve = of(energies);
        shadow.setAttribute('points', shadows ? points(of(shadows)) : '');
        named.textContent = shadows ? 'dashed: shadow energy' : '';
        ended.textContent = `${oddity.written(end)} s`;
      },
      now(steps) { way.setAttribute('points', points(curve.slice(0, steps + 1))); },
    };
  };
})(window.oddity = window.oddity || {});
