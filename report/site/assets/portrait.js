// Phase portraits: an observable against its rate, for the truth and each method, with where they are now.

(function (oddity) {
  'use strict';

  const looks = 600;   // at a motion
  const margin = { left: 12, right: 12, top: 18, bottom: 20 };
  const beyond = 0.6;  // room for methods around the truth, relative to half of its extent

  /** [{t, place, rate}] of one observable, the rate by differences of places. */
  oddity.phases = function (see, motion, end, nth) {
    const step = end / looks;
    const at = (t) => see(motion, Math.min(Math.max(t, 0), end))[nth];
    return Array.from({ length: looks + 1 }, (_, i) => {
      const t = i * step, before = Math.max(t - step / 2, 0), after = Math.min(t + step / 2, end);
      return { t, place: at(t), rate: (at(after) - at(before)) / (after - before) };
    });
  };

  /** From the least to the largest that is known, with room on both sides. */
  function extent(values) {
    const known = values.filter(Number.isFinite);
    const [least, most] = [Math.min(...known), Math.max(...known)];
    const room = beyond * (most - least) / 2 || 1;
    return [least - room, most + room];
  }

  /** {set({name, unit, series: [{phases, colour, ghost, shape}]}), paint(t), resize()}. The first is the truth. */
  oddity.portrait = function (canvas) {
    const pen = canvas.getContext('2d');
    let shown = null, now = 0, width = 0, height = 0, colours = {};

    const x = (place) => margin.left + (width - margin.left - margin.right) * (place - shown.places[0]) / (shown.places[1] - shown.places[0]);
    const y = (rate) => height - margin.bottom - (height - margin.top - margin.bottom) * (rate - shown.rates[0]) / (shown.rates[1] - shown.rates[0]);

    function way({ phases, colour, ghost, shape }) {
      pen.strokeStyle = pen.fillStyle = colour;
      pen.lineWidth = ghost ? 5 : 1.6;
      pen.globalAlpha = ghost ? 0.35 : 1;
      pen.setLineDash(ghost ? [] : oddity.dashes[shape]);
      pen.beginPath();
      let last = null;
      for (const phase of phases) {
        if ((!ghost && phase.t > now) || !Number.isFinite(phase.place) || !Number.isFinite(phase.rate)) break;
        if (last) pen.lineTo(x(phase.place), y(phase.rate));
        else pen.moveTo(x(phase.place), y(phase.rate));
        last = phase;
      }
      pen.stroke();
      pen.setLineDash([]);
      pen.globalAlpha = 1;
      const here = ghost ? phases.findLast((phase) => phase.t <= now) : last;
      if (here) oddity.mark(pen, ghost ? 0 : shape, x(here.place), y(here.rate), 4);
    }

    function axes() {
      pen.strokeStyle = colours.line;
      pen.lineWidth = 1;
      pen.beginPath();
      pen.moveTo(margin.left, y(0));
      pen.lineTo(width - margin.right, y(0));
      pen.moveTo(x(0), margin.top);
      pen.lineTo(x(0), height - margin.bottom);
      pen.stroke();
      pen.fillStyle = colours.quiet;
      pen.font = colours.font;
      pen.textBaseline = 'bottom';
      pen.textAlign = 'right';
      pen.fillText(shown.name, width - margin.right, height - 4);
      pen.textBaseline = 'top';
      pen.textAlign = 'left';
      pen.fillText(`rate of ${shown.name}`, margin.left, 3);
    }

    return {
      set(next) {
        const [truth] = next.series;
        shown = { ...next, places: extent(truth.phases.map((p) => p.place)), rates: extent(truth.phases.map((p) => p.rate)) };
      },
      paint(t) {
        now = t;
        if (!shown || !width) return;
        pen.clearRect(0, 0, width, height);
        pen.save();
        axes();
        pen.beginPath();
        pen.rect(0, margin.top, width, height - margin.top - margin.bottom);
        pen.clip();
        shown.series.forEach(way);
        pen.restore();
      },
      resize() {
        const ratio = window.devicePixelRatio || 1, style = getComputedStyle(canvas);
        [width, height] = [canvas.clientWidth, canvas.clientHeight];
        [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
        pen.setTransform(ratio, 0, 0, ratio, 0, 0);
        const colour = (name, other) => style.getPropertyValue(name).trim() || other;
        colours = { quiet: colour('--quiet', '#666'), line: colour('--strong-line', '#999'), font: `11px ${colour('--ui-font', 'sans-serif')}` };
        this.paint(now);
      },
    };
  };
})(window.oddity = window.oddity || {});
