// The trials of a quantity as a table in every <div class="trials" data-quantity="NAME">, folded until
// opened. Its rows and the chart's points highlight each other.
(function (oddity) {
  'use strict';

  const {
    number,
    count,
    duration,
    element,
    methodsOf,
    contextOf,
    quantityNamed,
    detailOf,
    isPoint,
    said,
    play,
  } = oddity.charts;

  /** Compares two values of a column: numbers by size, missing ones last; words alphabetically. */
  function compared(a, b) {
    const none = (x) => x === null || x === '' || Number.isNaN(x);
    if (none(a) || none(b)) return none(a) - none(b);
    return typeof a === 'string' ? a.localeCompare(b) : a - b;
  }

  /** Sorted by a column, up or down; missing values stay last. */
  function sorted(points, value, down) {
    const none = (p) => value(p) === null || value(p) === '';
    return [...points].sort((a, b) =>
      none(a) || none(b) ? none(a) - none(b) : (down ? -1 : 1) * compared(value(a), value(b)),
    );
  }

  function columnsOf(quantity, context) {
    const resolutions = new Set(quantity.methods.map((m) => m.resolution).filter(Boolean));
    const unit = quantity.unit && quantity.unit !== '1' ? ' [' + quantity.unit + ']' : '';
    const timed = quantity.methods.some((m) => m.trials.some((trial) => trial[3] !== null));
    const time = {
      name: 'time',
      value: (p) => p.ns,
      text: (p) => (p.ns === null ? '' : duration(p.ns)),
      numeric: true,
    };
    const columns = [
      { name: 'model', value: (p) => p.method.model },
      {
        name: 'algorithm',
        value: (p) => p.method.algorithm + (p.method.precision === 'float' ? ' in float' : ''),
      },
      {
        name: 'error' + unit,
        value: (p) => p.error,
        text: (p) => (p.error === null ? 'no number' : number(p.error, 3)),
        numeric: true,
      },
      { name: 'evaluations', value: (p) => p.evaluations, text: (p) => count(p.evaluations), numeric: true },
      ...(timed ? [time] : []),
      { name: 'outcome', value: (p) => context.outcomes[p.outcome] || p.outcome },
    ];
    if (resolutions.size) {
      const only = resolutions.size === 1 ? [...resolutions][0] : 'setting';
      columns.splice(2, 0, {
        name: only,
        value: (p) => (p.method.resolution ? p.setting : null),
        numeric: true,
        text: (p) =>
          !p.method.resolution ? '' : (resolutions.size > 1 ? p.method.resolution + ' ' : '') + number(p.setting, 3),
      });
    }
    return columns;
  }

  function table(quantity, context) {
    const columns = columnsOf(quantity, context);
    let points = methodsOf(quantity, context.styles).flatMap((m) => m.points);
    const rows = new Map();
    const body = element('tbody');
    const order = { column: null, down: false };

    for (const p of points) {
      const row = element('tr', { tabindex: '-1' });
      columns.forEach((c, i) =>
        row.append(
          element(
            i ? 'td' : 'th',
            i ? { class: c.numeric ? 'number' : undefined } : { scope: 'row' },
            c.text ? c.text(p) : c.value(p),
          ),
        ),
      );
      row.dataset.outcome = p.outcome;
      rows.set(p, row);
    }

    function place() {
      body.replaceChildren(...points.map((p) => rows.get(p)));
      if (points.length) body.firstChild.tabIndex = 0;
    }
    const pointOf = (target) => {
      const row = target.closest('tbody tr');
      return points.find((p) => rows.get(p) === row);
    };
    const light = (detail) => {
      for (const [p, row] of rows) row.classList.toggle('lit', isPoint(p, detail));
    };

    const heads = columns.map((c) => {
      const button = element('button', { type: 'button' }, c.name);
      const head = element('th', { scope: 'col', class: c.numeric ? 'number' : undefined }, button);
      button.addEventListener('click', () => {
        order.down = order.column === c && !order.down;
        order.column = c;
        for (const other of heads) other.removeAttribute('aria-sort');
        head.setAttribute('aria-sort', order.down ? 'descending' : 'ascending');
        points = sorted(points, c.value, order.down);
        for (const row of rows.values()) row.tabIndex = -1;
        place();
      });
      return head;
    });

    body.addEventListener('focusin', (event) => {
      const p = pointOf(event.target);
      if (!p) return;
      for (const row of rows.values()) row.tabIndex = -1;
      rows.get(p).tabIndex = 0;
      said(detailOf(p, quantity));
    });
    body.addEventListener('pointerover', (event) => {
      const p = event.pointerType === 'touch' ? null : pointOf(event.target);
      if (p) said(detailOf(p, quantity));
    });
    body.addEventListener('click', (event) => {
      const p = pointOf(event.target);
      if (p && context.plays) play(detailOf(p, quantity));
    });
    body.addEventListener('keydown', (event) => {
      const p = pointOf(event.target);
      if (!p) return;
      const all = points,
        at = all.indexOf(p);
      const next = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: all.length - 1 }[event.key];
      if (event.key === 'Enter' && context.plays) play(detailOf(p, quantity));
      else if (next !== undefined && all[next]) rows.get(all[next]).focus();
      else return;
      event.preventDefault();
    });
    document.addEventListener('oddity:point', (event) => {
      if (event.detail && event.detail.quantity === quantity.name && !event.detail.parameters)
        light(event.detail);
    });
    place();
    const made = element(
      'table',
      { class: context.plays ? 'plays' : undefined },
      element('caption', {}, quantity.says + (context.plays ? '. Enter or a click on a row plays it.' : '')),
      element('thead', {}, element('tr', {}, ...heads)),
      body,
    );
    return { made, light };
  }

  /** Folded; the table is made when it is first opened. */
  function fold(place, quantity, context) {
    const trials = quantity.methods.reduce((sum, m) => sum + m.trials.length, 0);
    const summary = element(
      'summary',
      {},
      'All ' + count(trials) + ' trials of ' + count(quantity.methods.length) + ' methods as a table',
    );
    const details = element('details', {}, summary);
    let last = null;
    document.addEventListener('oddity:point', (event) => {
      if (event.detail && event.detail.quantity === quantity.name) last = event.detail;
    });
    details.addEventListener('toggle', () => {
      if (!details.open || details.children.length > 1) return;
      const { made, light } = table(quantity, context);
      details.append(
        element(
          'div',
          { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'trials of ' + quantity.name },
          made,
        ),
      );
      if (last) light(last);
    });
    place.replaceChildren(details);
  }

  function start() {
    for (const place of document.querySelectorAll('div.trials[data-quantity]')) {
      const quantity = quantityNamed(place.dataset.quantity);
      if (quantity) fold(place, quantity, contextOf(oddity.data, quantity));
    }
  }

  oddity.trials = { compared, sorted, columnsOf };
  if (typeof document !== 'undefined') oddity.charts.whenReady(() => oddity.with_data(start));
})((window.oddity = window.oddity || {}));
