// The stability map of a scene. Every <figure class="map"> becomes tables of each method's outcomes over the
// step and the parameter that makes the scene hard, with linear theory's border and the limits.
(function (oddity) {
  'use strict';

  const { number, element, svg, inUnit, play, said, needOfGame, whenNear } = oddity.charts;

  /** Place of theory's limit in a panel, in rows from the top: steps fall by a constant factor. */
  function border(theory, steps) {
    if (theory === null) return 0;
    if (!(theory > 0)) return steps.length;
    const fall = Math.log(steps[0] / steps[1]);
    return Math.min(steps.length, Math.max(0, 0.5 + Math.log(steps[0] / theory) / fall));
  }

  /** The border as a line through the columns of a panel, in units of cells. */
  function borderPath(rows, steps) {
    return rows
      .map(([, theory], i) => {
        const y = border(theory, steps).toFixed(3);
        return (i ? 'V' + y : 'M0,' + y) + 'H' + (i + 1);
      })
      .join('');
  }

  /** The longest step up to which a method ends ok at every value; 0 if it never does. */
  function longestOk(method, steps) {
    let longest = 0;
    for (let k = steps.length - 1; k >= 0; --k) {
      if (method.rows.some(([, , outcomes]) => outcomes[k] !== 'o')) break;
      longest = steps[k];
    }
    return longest;
  }

  function finding(stability, timeUnit) {
    const { map, steps, parameter } = stability;
    const best = map.reduce((a, b) => (a && longestOk(a, steps) >= longestOk(b, steps) ? a : b), null);
    const longest = best ? longestOk(best, steps) : 0;
    return longest
      ? best.algorithm +
          ' (' +
          best.model +
          ') ends ok at every ' +
          parameter +
          ' up to the longest step, ' +
          number(longest, 3) +
          ' ' +
          timeUnit +
          '.'
      : 'No method ends ok at every ' + parameter + '.';
  }

  const words = (cell, context) =>
    [
      cell.method.algorithm + ' (' + cell.method.model + ')',
      context.parameter + ' = ' + inUnit(cell.value, context.unit, 4),
      'step ' + number(cell.step, 3) + ' ' + context.timeUnit,
      context.outcomes[cell.letter] + (cell.fragile ? ', which a few roundings at the start decide' : ''),
    ].join(', ');

  function panel(method, context, cells) {
    const { steps } = context;
    const head = element('tr', {}, element('td'));
    for (const [value] of method.rows) head.append(element('th', { scope: 'col' }, number(value, 3)));
    const body = element('tbody');
    steps.forEach((step, k) => {
      const row = element('tr', {}, element('th', { scope: 'row' }, String(Number(step.toPrecision(2)))));
      for (const [value, , outcomes, marks] of method.rows) {
        const fragile = marks[k] === '*';
        const cell = {
          method,
          value,
          step,
          letter: outcomes[k],
          fragile,
          panel: body,
          node: element(
            'td',
            { tabindex: '-1', class: 'cell cell-' + outcomes[k] + (fragile ? ' fragile' : '') },
            outcomes[k],
          ),
        };
        cell.node.setAttribute('aria-label', context.outcomes[cell.letter] + (fragile ? ', by roundings' : ''));
        cells.set(cell.node, cell);
        row.append(cell.node);
      }
      body.append(row);
    });
    const over = svg('svg', {
      class: 'border',
      viewBox: `0 0 ${method.rows.length} ${steps.length}`,
      preserveAspectRatio: 'none',
      'aria-hidden': 'true',
    });
    const d = borderPath(method.rows, steps);
    over.append(svg('path', { class: 'under', d }), svg('path', { d }));
    const made = element(
      'div',
      { class: 'panel' },
      element('p', { 'aria-hidden': 'true' }, method.algorithm),
      element(
        'table',
        { 'aria-label': method.algorithm + ', ' + method.model },
        element('thead', {}, head),
        body,
      ),
      over,
    );
    made.style.setProperty('--columns', method.rows.length);
    made.style.setProperty('--rows', steps.length);
    return made;
  }

  function legend(map, context) {
    const present = new Set(map.flatMap((m) => m.rows.flatMap(([, , outcomes]) => [...outcomes])));
    const made = element('p', { class: 'map-legend' });
    for (const [letter, name] of Object.entries(context.outcomes))
      if (present.has(letter))
        made.append(
          element(
            'span',
            {},
            element('b', { class: 'cell cell-' + letter, 'aria-hidden': 'true' }, letter),
            name,
          ),
        );
    const marked = map.flatMap((m) => m.rows).find(([, , , marks]) => marks);
    if (marked) {
      const letter = marked[2][marked[3].indexOf('*')];
      made.append(
        element(
          'span',
          {},
          element('b', { class: 'cell fragile cell-' + letter, 'aria-hidden': 'true' }, letter),
          'a few roundings at the start decide',
        ),
      );
    }
    made.append(
      element(
        'span',
        {},
        element('b', { class: 'theory', 'aria-hidden': 'true' }),
        'limit of linear theory: stable below the line',
      ),
    );
    return made;
  }

  const inTheory = (limit) =>
    limit.theory === null ? 'every step' : limit.theory > 0 ? number(limit.theory, 3) : 'none';

  function limits(stability, context, close) {
    const head = [
      'model',
      'algorithm',
      `stable up to [${context.timeUnit}]`,
      'by theory',
      close ? 'within ' + close + ' up to' : 'within need up to',
    ];
    const rows = stability.limits.map((l) =>
      element(
        'tr',
        {},
        element('th', { scope: 'row' }, l.model),
        element('td', {}, l.algorithm),
        element('td', { class: 'number' }, l.shown),
        element('td', { class: 'number' }, inTheory(l)),
        element('td', { class: 'number' }, l.within === null ? 'none' : number(l.within, 3)),
      ),
    );
    return element(
      'details',
      { class: 'limits' },
      element('summary', {}, 'The largest stable steps as a table'),
      element(
        'div',
        { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'largest stable steps' },
        element(
          'table',
          {},
          element(
            'caption',
            {},
            'As the book has the scene. Stable: a small disturbance does not grow that does not grow in truth.',
          ),
          element(
            'thead',
            {},
            element(
              'tr',
              {},
              ...head.map((text, i) =>
                element('th', { scope: 'col', class: i > 1 ? 'number' : undefined }, text),
              ),
            ),
          ),
          element('tbody', {}, ...rows),
        ),
      ),
    );
  }

  function show(figure, data) {
    const { stability, scene } = data;
    const quantity = data.quantities[scene.quantity];
    const context = {
      steps: stability.steps,
      parameter: stability.parameter,
      unit: stability.unit,
      outcomes: data.outcomes,
      timeUnit: scene.time_unit,
    };
    const close = Object.entries(scene.close)
      .map(([unit, error]) => needOfGame(error, unit))
      .join(', ');
    const usual = (data.parameters.find((p) => p.name === stability.parameter) || {}).value;
    const cells = new Map();
    const tip = element('p', { class: 'map-tip', 'aria-hidden': 'true' });
    const idle =
      'A cell names how the method ends at that ' + stability.parameter + ' and step; a click plays it.';
    tip.textContent = idle;

    const groups = [];
    for (const method of stability.map) {
      let group = groups.find((g) => g.model === method.model);
      if (!group) groups.push((group = { model: method.model, panels: [] }));
      group.panels.push(panel(method, context, cells));
    }
    const panels = groups.flatMap((g) => [
      element('p', { class: 'model' }, g.model),
      element('div', { class: 'panels' }, ...g.panels),
    ]);
    figure.replaceChildren(
      element(
        'figcaption',
        {},
        element('strong', { class: 'finding' }, finding(stability, context.timeUnit)),
        element(
          'span',
          { class: 'says' },
          'How each method ends: ' +
            stability.parameter +
            (stability.unit && stability.unit !== '1' ? ' [' + stability.unit + ']' : '') +
            ' across, the step [' +
            context.timeUnit +
            '] down',
        ),
      ),
      legend(stability.map, context),
      tip,
      ...panels,
      limits(stability, context, close),
    );

    const detail = (cell) => ({
      quantity: quantity.name,
      model: cell.method.model,
      algorithm: cell.method.algorithm,
      precision: 'double',
      setting: cell.step,
      parameters: { [stability.parameter]: cell.value },
    });
    const pick = (cell) => {
      for (const node of cells.keys()) node.tabIndex = -1;
      cell.node.tabIndex = 0;
      tip.textContent = words(cell, context);
      const asked = detail(cell);
      if (cell.value === usual) delete asked.parameters;
      said(asked);
    };
    const cellOf = (event) => cells.get(event.target.closest ? event.target.closest('td.cell') : null);
    const neighbour = (cell, key) => {
      const node = cell.node,
        row = node.parentNode,
        column = [...row.children].indexOf(node);
      if (key === 'ArrowLeft') return node.previousElementSibling;
      if (key === 'ArrowRight') return node.nextElementSibling;
      const other = key === 'ArrowUp' ? row.previousElementSibling : row.nextElementSibling;
      if (other) return other.children[column];
      const bodies = [...new Set([...cells.values()].map((c) => c.panel))];
      const next = bodies[bodies.indexOf(cell.panel) + (key === 'ArrowUp' ? -1 : 1)];
      const line = next && (key === 'ArrowUp' ? next.lastElementChild : next.firstElementChild);
      return line && line.children[Math.min(column, line.children.length - 1)];
    };
    const first = cells.keys().next().value;
    if (first) first.tabIndex = 0;
    figure.addEventListener('pointerover', (event) => {
      const cell = cellOf(event);
      if (cell && event.pointerType !== 'touch') pick(cell);
    });
    figure.addEventListener('focusin', (event) => {
      const cell = cellOf(event);
      if (cell) pick(cell);
    });
    figure.addEventListener('click', (event) => {
      const cell = cellOf(event);
      if (cell) play(detail(cell));
    });
    figure.addEventListener('keydown', (event) => {
      const cell = cellOf(event);
      if (!cell) return;
      if (event.key === 'Enter' || event.key === ' ') play(detail(cell));
      else if (event.key.startsWith('Arrow')) {
        const next = neighbour(cell, event.key);
        if (cells.has(next)) next.focus();
      } else return;
      event.preventDefault();
    });
    document.addEventListener('oddity:point', (event) => {
      if (event.detail && event.detail.quantity === quantity.name)
        light(cells, event.detail, stability, usual);
    });
  }

  /** The cell of the same method and parameter, and of the nearest step. */
  function light(cells, detail, stability, usual) {
    const value = detail.parameters ? detail.parameters[stability.parameter] : usual;
    const near = (list, x) =>
      list.reduce((a, b) => (Math.abs(Math.log(b / x)) < Math.abs(Math.log(a / x)) ? b : a));
    const step = detail.setting > 0 ? near(stability.steps, detail.setting) : null;
    const values = [...new Set([...cells.values()].map((c) => c.value))];
    const column = values.reduce((a, b) => (Math.abs(b - value) < Math.abs(a - value) ? b : a), values[0]);
    for (const [node, cell] of cells)
      node.classList.toggle(
        'lit',
        cell.method.model === detail.model &&
          cell.method.algorithm === detail.algorithm &&
          cell.step === step &&
          cell.value === column,
      );
  }

  function start() {
    if (!oddity.data.stability || !oddity.data.scene) return;
    for (const figure of document.querySelectorAll('figure.map'))
      whenNear(figure, () => show(figure, oddity.data));
  }

  oddity.map = { border, borderPath, longestOk, finding };
  if (typeof document !== 'undefined') oddity.charts.whenReady(() => oddity.with_data(start));
})((window.oddity = window.oddity || {}));
