// Quantities that grow along a motion, on a logarithmic scale: oddity.lines(canvas).

(function (oddity) {
  'use strict';

  const margin = { left: 46, right: 12, top: 8, bottom: 20 };
  const most = 9;    // decades shown
  const few = 45;    // steps up to which each is shown
  const dashes = [[], [7, 4], [2, 3], [9, 3, 2, 3]];

  /** The marks of the methods, by index, distinguishable without colour. */
  oddity.mark = function (context, shape, x, y, r) {
    context.beginPath();
    if (shape === 0) context.arc(x, y, r, 0, 2 * Math.PI);
    if (shape === 1) context.rect(x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r);
    if (shape === 2) {
      context.moveTo(x, y - 1.2 * r);
      context.lineTo(x + 1.1 * r, y + 0.8 * r);
      context.lineTo(x - 1.1 * r, y + 0.8 * r);
    }
    if (shape === 3) {
      context.moveTo(x, y - 1.3 * r);
      context.lineTo(x + 1.3 * r, y);
      context.lineTo(x, y + 1.3 * r);
      context.lineTo(x - 1.3 * r, y);
    }
    context.closePath();
    context.fill();
  };
  oddity.dashes = dashes;

  const power = (n) => '10' + String(n).replace(/./g, (c) => (c === '-' ? '\u207b' : '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079'[c]));

  /** The decades shown: from the smallest relevant value to the largest, including the need. */
  function decadesOf({ series, need, floor, ceiling }) {
    let low = Infinity;
    let high = need || 0;
    for (const { values } of series) {
      for (let i = 0; i < values.length; i += 1) {
        if (!(values[i] > 0)) continue;
        if (values[i] > high) high = Math.min(values[i], ceiling);
        if (8 * i > values.length && values[i] < low) low = values[i];
      }
    }
    if (!(high > 0)) high = 1;
    const to = Math.ceil(Math.log10(high) + 0.05);
    const from = Math.floor(Math.log10(Math.max(floor, Math.min(low, need || high) / 2)));
    return { from: Math.max(to - most, Math.min(from, to - 2)), to };
  }

  oddity.lines = function (canvas) {
    const behind = document.createElement('canvas');     // the axes, which are the same in all frames
    const pens = [canvas.getContext('2d'), behind.getContext('2d')];
    let [context] = pens;
    let shown = null;
    let now = 0;
    let colours = {};

    let width = 0;     // read from the page only after changes, as reading forces a layout
    let height = 0;
    const x = (t) => margin.left + (width - margin.left - margin.right) * t / shown.end;
    function y(value) {
      const { from, to } = shown.decades;
      const place = (Math.log10(value) - from) / (to - from);
      return height - margin.bottom - (height - margin.top - margin.bottom) * Math.min(1, Math.max(0, place));
    }

    function resize() {
      const ratio = window.devicePixelRatio || 1;
      width = canvas.clientWidth;
      height = canvas.clientHeight;
      for (const pen of pens) {
        pen.canvas.width = Math.round(width * ratio);
        pen.canvas.height = Math.round(height * ratio);
        pen.setTransform(ratio, 0, 0, ratio, 0, 0);
      }
      const style = getComputedStyle(canvas);
      const colour = (name, other) => style.getPropertyValue(name).trim() || other;
      colours = { ink: colour('--ink', '#222'), quiet: colour('--quiet', '#666'), line: colour('--line', '#ccc'),
        need: colour('--right', '#1c6a41'), font: `11px ${colour('--ui-font', 'sans-serif')}` };
    }

    function straight(x0, y0, x1, y1, colour, dash = []) {
      context.strokeStyle = colour;
      context.lineWidth = 1;
      context.setLineDash(dash);
      context.beginPath();
      context.moveTo(x0, y0);
      context.lineTo(x1, y1);
      context.stroke();
      context.setLineDash([]);
    }

    function axes() {
      const { from, to } = shown.decades;
      const right = width - margin.right;
      const every = Math.ceil((to - from) / Math.max(2, Math.floor((height - 28) / 22)));
      context.font = colours.font;
      context.fillStyle = colours.quiet;
      context.textAlign = 'right';
      context.textBaseline = 'middle';
      for (let n = from; n <= to; n += every) {
        const at = Math.round(y(Math.pow(10, n))) + 0.5;
        straight(margin.left, at, right, at, colours.line);
        context.fillText(power(n), margin.left - 6, at);
      }
      context.textBaseline = 'top';
      const ticks = shown.ticks;
      ticks.forEach((t, i) => {
        context.textAlign = i === ticks.length - 1 ? 'right' : i ? 'center' : 'left';
        const text = i === ticks.length - 1 ? `${oddity.written(t)} ${shown.timeUnit}` : oddity.written(t);
        context.fillText(text, i === ticks.length - 1 ? right : x(t), height - margin.bottom + 5);
      });
    }

    function need() {
      if (!shown.need) return;
      const at = Math.round(y(shown.need)) + 0.5;
      straight(margin.left, at, width - margin.right, at, colours.need, [3, 3]);
      context.fillStyle = colours.need;
      context.textAlign = 'left';
      context.textBaseline = 'bottom';
      context.fillText(shown.needName, margin.left + 4, at - 1);
    }

    function line({ times, values, colour, shape }) {
      context.strokeStyle = context.fillStyle = colour;
      context.lineWidth = 1.8;
      context.setLineDash(dashes[shape]);
      context.beginPath();
      let last = -1;
      for (let i = 1; i < times.length && times[i] <= now + 1e-9; i += 1) {
        if (!Number.isFinite(values[i])) break;
        const at = y(Math.max(values[i], 1e-300));
        if (last < 0) context.moveTo(x(times[i]), at);
        else context.lineTo(x(times[i]), at);
        last = i;
      }
      context.stroke();
      context.setLineDash([]);
      if (last < 0) return;
      if (times.length < few)
        for (let i = 1; i < last; i += 1) oddity.mark(context, shape, x(times[i]), y(Math.max(values[i], 1e-300)), 2.5);
      oddity.mark(context, shape, x(times[last]), y(Math.max(values[last], 1e-300)), 4);
      if (last + 1 < times.length && times[last + 1] <= now && !Number.isFinite(values[last + 1]))
        cross(x(times[last]), margin.top + 5);
    }

    function cross(cx, cy) {
      context.lineWidth = 2;
      context.beginPath();
      context.moveTo(cx - 4, cy - 4);
      context.lineTo(cx + 4, cy + 4);
      context.moveTo(cx + 4, cy - 4);
      context.lineTo(cx - 4, cy + 4);
      context.stroke();
    }

    function ground() {
      if (!shown || !width) return;
      context = pens[1];
      context.clearRect(0, 0, width, height);
      axes();
      need();
      context = pens[0];
    }

    function paint(t) {
      now = t;
      if (!shown || !width) return;
      context.clearRect(0, 0, width, height);
      context.drawImage(behind, 0, 0, width, height);
      straight(Math.round(x(t)) + 0.5, margin.top, Math.round(x(t)) + 0.5, height - margin.bottom, colours.quiet);
      shown.series.forEach(line);
    }

    return {
      /** {series: [{times, values, colour, shape}], need, needName, floor, ceiling, end, ticks, timeUnit}. */
      set(next) {
        shown = { ...next, decades: decadesOf(next) };
        ground();
      },
      paint,
      resize() {
        resize();
        ground();
        paint(now);
      },
    };
  };
})(window.oddity = window.oddity || {});
