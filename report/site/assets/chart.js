// Interactive charts, one for every <figure class="chart" data-quantity="NAME">. Their points highlight rows
// and cells of table and map, and play their trial. A legend switches models, algorithms, precisions and
// outcomes on and off.
(function (oddity) {
  'use strict';

  const {
    needOfGame,
    colourOf,
    lettered,
    methodsOf,
    sentence,
    mainResolution,
    mostCurves,
    finding,
    description,
    element,
    svg,
    mark,
    swatch,
    choice,
    workPrecision,
    rows,
  } = oddity.charts;

  // ---- the chart -------------------------------------------------------------------------------------------

  let last = null; // the point named last, in any chart
  if (typeof document !== 'undefined')
    document.addEventListener('oddity:point', (event) => {
      last = event.detail;
    });
  const said = (detail) => document.dispatchEvent(new CustomEvent('oddity:point', { detail }));
  const play = (detail) => document.dispatchEvent(new CustomEvent('oddity:play', { detail }));

  const detailOf = (p, quantity) => ({
    quantity: quantity.name,
    model: p.method.model,
    algorithm: p.method.algorithm,
    precision: p.method.precision,
    setting: p.setting,
  });

  const isOf = (p, detail) =>
    p.method.model === detail.model &&
    p.method.algorithm === detail.algorithm &&
    p.method.precision === detail.precision;
  const isPoint = (p, detail) =>
    isOf(p, detail) && Math.abs(p.setting - detail.setting) <= 1e-6 * Math.abs(p.setting);

  /** State of the filter: names that are switched off, by kind. */
  function filter() {
    const off = { model: new Set(), algorithm: new Set(), precision: new Set(['float']), outcome: new Set() };
    return {
      off,
      method: (m) =>
        !off.model.has(m.model) && !off.algorithm.has(m.algorithm) && !off.precision.has(m.precision),
      point: (p) => !off.outcome.has(p.outcome),
    };
  }

  /** The methods that pass the filter, with the points that pass it. */
  function left(methods, shown) {
    return methods
      .filter(shown.method)
      .map((m) => {
        const copy = { ...m };
        copy.points = m.points.filter(shown.point).map((p) => ({ ...p, method: copy }));
        return copy;
      })
      .filter((m) => m.points.length);
  }

  const axisTitles = { time: 'time', evaluations: 'evaluations' };

  /** A chart in a figure. `context` is `{styles, outcomes, timeUnit, close: [{error, says}], game, plays, floats,
      chosen}`. `close` has a game's tolerance in each unit; `game` is that of the only unit, or null. `plays`:
      clicks play. `floats`: methods in float are shown. `chosen`: a method that is always in colour. */
  function chart(figure, quantity, context) {
    const all = methodsOf(quantity, context.styles);
    const shown = filter();
    context.font = () => getComputedStyle(plot).fontFamily;
    if (context.floats || !all.some((m) => m.precision === 'double')) shown.off.precision.clear();
    const families = new Set(all.map((m) => context.styles.families[m.algorithm]).filter(Boolean));
    const view = {
      axis: quantity.charts[0] || null,
      every: false,
      picked: last && last.quantity === quantity.name ? last : null,
      by: families.size > 2 ? 'family' : 'model',
    };
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
      const drawing = view.axis
        ? workPrecision(quantity, methods, chosen.concat(found.of), view, context, plot.clientWidth)
        : rows(quantity, methods, view, context, plot.clientWidth);

      spots = drawing.spots;
      drawing.svg.setAttribute(
        'aria-label',
        title.textContent + ' Each point is a trial; the arrow keys go from one to the next.',
      );
      plot.replaceChildren(drawing.svg, tip);
      tip.hidden = true;
      const at =
        spots.find((s) => view.picked && isPoint(s.point, view.picked)) ||
        spots.find((s) => s.first) ||
        spots[0];
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
      tip.replaceChildren(
        element('b', {}, lines[0]),
        ...lines.slice(1).map((line) => element('span', {}, line)),
      );
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
      const x = event.clientX - box.left,
        y = event.clientY - box.top;
      const far = (s) => Math.hypot(s.x - x, s.y - y) + (s.pale ? 6 : 0);
      const found = spots.reduce((a, b) => (a && far(a) <= far(b) ? a : b), null);
      return found && far(found) < 26 ? found : null;
    }

    function neighbour(spot, key) {
      const order = [...new Set(spots.map((s) => s.point.method))];
      const mine = spots.filter((s) => s.point.method === spot.point.method);
      const place = mine.indexOf(spot),
        step = key === 'ArrowRight' || key === 'ArrowDown' ? 1 : -1;
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
    plot.addEventListener('pointerleave', () => {
      tip.hidden = true;
    });
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
    plot.addEventListener('focusout', () => {
      tip.hidden = true;
    });
    plot.addEventListener('keydown', (event) => {
      const spot = spots.find((s) => s.node === document.activeElement);
      if (!spot) return;
      if (event.key === 'Escape') tip.hidden = true;
      else if (event.key === 'Enter' || event.key === ' ') {
        if (context.plays) play(detailOf(spot.point, quantity));
      } else if (/^(Arrow|Home$|End$)/.test(event.key)) {
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
      const names = { ...axisTitles, setting: mainResolution(all) };
      tools.append(
        choice(
          'error against',
          quantity.charts.map((axis) => [axis, names[axis]]),
          view.axis,
          (axis) => {
            view.axis = axis;
            draw();
          },
        ),
      );
    }
    if (view.axis && all.length > mostCurves)
      tools.append(
        choice(
          'curves',
          [
            [false, 'the best'],
            [true, 'all'],
          ],
          false,
          (every) => {
            view.every = every;
            draw();
          },
        ),
      );
    if (families.size > 2 && new Set(all.map((m) => m.model)).size > 1)
      tools.append(
        choice(
          'colours',
          [
            ['family', 'colours by algorithm'],
            ['model', 'by model'],
          ],
          view.by,
          (by) => {
            view.by = by;
            draw();
            recolour();
          },
        ),
      );
    const [buttons, recolour] = legend(all, shown, context, view, draw);
    subtitle.textContent =
      quantity.says + (quantity.samples > 1 ? '; judged at these ' + quantity.samples + ' times alone' : '');
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

  /** Buttons that switch models, algorithms, precisions and outcomes on and off, or choose the colours again.
      */
  function legend(methods, shown, context, view, draw) {
    const details = element('details', { class: 'legend' }, element('summary', {}, 'Show and hide'));
    const distinct = (values) => [...new Set(values)];
    const letters = Object.keys(context.outcomes);
    const ofKind = {
      model: (name) => methods.find((m) => m.model === name),
      algorithm: (name) => methods.find((m) => m.algorithm === name),
    };
    const kinds = [
      [
        'model',
        'models',
        distinct(methods.map((m) => m.model)),
        () => swatch(svg('rect', { x: -7, y: -4, width: 14, height: 8, class: 'fill' })),
      ],
      [
        'algorithm',
        'algorithms',
        distinct(methods.map((m) => m.algorithm)),
        (name) => swatch(mark(ofKind.algorithm(name).mark, 4.6)),
      ],
      [
        'precision',
        'precisions',
        distinct(methods.map((m) => m.precision)),
        (name) => swatch(svg('path', { d: 'M-8,0H8', class: 'line ' + name })),
      ],
      [
        'outcome',
        'outcomes',
        distinct(methods.flatMap((m) => m.points.map((p) => p.outcome))).sort(
          (a, b) => letters.indexOf(a) - letters.indexOf(b),
        ),
        (letter) =>
          lettered(letter) ? element('span', { class: 'letter', 'aria-hidden': 'true' }, letter) : '',
      ],
    ].filter(([, , names]) => names.length > 1);
    const coloured = [];
    for (const [kind, says, names, picture] of kinds) {
      const off = shown.off[kind];
      const buttons = names.map((name) => {
        const button = element(
          'button',
          { type: 'button' },
          picture(name),
          kind === 'outcome' ? context.outcomes[name] || name : name,
        );
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
      const refresh = () => {
        press();
        draw();
      };
      press();
      details.append(
        element(
          'div',
          { class: 'kind', role: 'group', 'aria-label': says },
          element('span', { class: 'kind-name' }, says),
          ...buttons,
          ...(names.length > 4 ? [all] : []),
        ),
      );
    }
    const recolour = () => {
      for (const [kind, m, button] of coloured)
        button.style.setProperty(
          '--c',
          (kind === 'model') === (view.by === 'model') ? colourOf(m, view.by) : 'currentColor',
        );
    };
    recolour();
    details.open = figureIsWide() && kinds.reduce((sum, [, , names]) => sum + names.length, 0) <= 14;
    return [kinds.length ? details : '', recolour];
  }

  const figureIsWide = () => window.matchMedia('(min-width: 700px)').matches;

  // ---- the page --------------------------------------------------------------------------------------------

  /** Shared data of a quantity's charts, tables and maps. */
  function contextOf(data, quantity) {
    const motion = data.scene && data.quantities[data.scene.quantity] === quantity;
    const close = motion
      ? Object.entries(data.scene.close).map(([unit, error]) => ({ error, says: needOfGame(error, unit) }))
      : [];
    return {
      styles: data.styles,
      outcomes: data.outcomes,
      close,
      plays: motion,
      timeUnit: data.scene ? data.scene.time_unit : '',
      game: close.length
        ? { error: Math.min(...close.map((c) => c.error)), says: close.map((c) => c.says).join(' and ') }
        : null,
    };
  }

  /** Acts when the element is about to be visible, or printed, so that a page of many charts opens at once. */
  function whenNear(place, act) {
    const observer = new IntersectionObserver((entries) => entries.some((entry) => entry.isIntersecting) && once(), {
      rootMargin: '800px',
    });
    let acted = false;
    function once() {
      if (acted) return;
      acted = true;
      observer.disconnect();
      act();
    }
    observer.observe(place);
    window.addEventListener('beforeprint', once);
  }

  const quantityNamed = (name) => oddity.data.quantities.find((q) => q.name === name);

  function start() {
    for (const figure of document.querySelectorAll('figure.chart[data-quantity]')) {
      const quantity = quantityNamed(figure.dataset.quantity);
      if (quantity) whenNear(figure, () => chart(figure, quantity, contextOf(oddity.data, quantity)));
    }
  }

  function whenReady(run) {
    if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', run);
    else run();
  }

  Object.assign(oddity.charts, {
    said,
    play,
    detailOf,
    isPoint,
    chart,
    contextOf,
    whenNear,
    quantityNamed,
    whenReady,
  });
  if (typeof document !== 'undefined') whenReady(() => oddity.with_data(start));
})((window.oddity = window.oddity || {}));
