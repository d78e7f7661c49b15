// Numbers for sliders and text: a value's place on a slider, and its text.

(function (oddity) {
  'use strict';

  const decades = 100;   // a wider range is logarithmic

  const evenly = (least, most) => ({
    value: (place) => least + place * (most - least),
    place: (value) => (value - least) / (most - least),
  });

  const byDecades = (least, most) => ({
    value: (place) => least * Math.pow(most / least, place),
    place: (value) => Math.log(value / least) / Math.log(most / least),
  });

  /** Logarithmic on both sides of zero, linear for values smaller than `small`. */
  const aboutZero = (least, most, small) => {
    const from = Math.asinh(least / small);
    const to = Math.asinh(most / small);
    return {
      value: (place) => small * Math.sinh(from + place * (to - from)),
      place: (value) => (Math.asinh(value / small) - from) / (to - from),
    };
  };

  /** Ends of a slider: those of the range, otherwise a span around the default. */
  function ends({ value, least, most }) {
    const about = Math.abs(value) || 1;
    return {
      least: Number.isFinite(least) ? least : value > 0 ? value / 4 : -4 * about,
      most: Number.isFinite(most) ? most : 4 * about,
    };
  }

  function layout({ value, unit }, least, most) {
    if (unit === 'rad') return evenly(least, most);
    if (least > 0) return most / least > decades ? byDecades(least, most) : evenly(least, most);
    const about = Math.abs(value) || 1;
    const far = Math.max(Math.abs(least), Math.abs(most));
    return far / about >= decades ? aboutZero(least, most, about) : evenly(least, most);
  }

  /** The number with the fewest digits within half of `spacing` of x, as near as those digits allow. */
  function roundedTo(x, spacing) {
    if (!(spacing > 0)) return x;
    const digit = Math.pow(10, Math.floor(Math.log10(spacing)));
    return Number((Math.round(x / digit) * digit).toPrecision(12));
  }

  /** A parameter's slider: `value(place)` and `place(value)`, place from 0 to 1, values round numbers. */
  oddity.scaleOf = function (parameter) {
    const { least, most } = ends(parameter);
    const { value, place } = layout(parameter, least, most);
    const within = (x) => Math.min(most, Math.max(least, x));
    const near = (p) => {
      if (p <= 0) return least;
      if (p >= 1) return most;
      const x = value(p);
      if (parameter.whole) return within(Math.round(x));
      return within(roundedTo(x, Math.abs(value(p + 0.0005) - value(p - 0.0005))));
    };
    return { least, most, value: near, place: (x) => Math.min(1, Math.max(0, place(x))) };
  };

  /** A value in its field: six digits, or 1/60 if it is such a fraction. */
  oddity.inField = function (x) {
    const inverse = 1 / x;
    const whole = Math.abs(inverse - Math.round(inverse)) <= 1e-12 * inverse;
    if (x > 0 && inverse <= 1e5 && whole && String(x).length > 6) return `1/${Math.round(inverse)}`;
    return String(Number(x.toPrecision(6)));
  };

  /** With this number of digits: 0.0175, 1.2e-7, 1234. */
  oddity.written = function (x, digits = 3) {
    if (Number.isNaN(x)) return '\u2013';
    if (!Number.isFinite(x)) return x > 0 ? '\u221e' : '\u2212\u221e';
    if (x === 0) return '0';
    const size = Math.abs(x);
    const text = size >= 1e-4 && size < 1e5
      ? String(Number(x.toPrecision(Math.max(digits, Math.ceil(Math.log10(size))))))
      : x.toExponential(digits - 1).replace(/\.?0+e/, 'e').replace('e+', 'e');
    return text.replace(/-/g, '\u2212');
  };

  /** A ratio, in percent or as a multiple. */
  oddity.part = function (x) {
    if (!Number.isFinite(x)) return oddity.written(x);
    if (x >= 10) return oddity.written(x, 2) + ' times';
    return oddity.written(100 * x, 2) + ' %';
  };

  const greek = { alpha: '\u03b1', theta: '\u03b8', lambda: '\u03bb', mu: '\u03bc', phi: '\u03c6', psi: '\u03c8', omega: '\u03c9' };
  const digits = (text, zero) => text.replace(/\d/g, (d) => zero[d]);

  /** A parameter's name as typeset: theta0_dot is a theta with a dot and a subscript. */
  oddity.letter = function (name) {
    const parts = /^(d?)(alpha|theta|lambda|mu|phi|psi|omega|[A-Za-z])(\d*)(_dot)?$/.exec(name);
    if (!parts) return name;
    const [, d, base, index, dot] = parts;
    return d + (greek[base] || base) + (dot ? '\u0307' : '') + digits(index, '\u2080\u2081\u2082\u2083\u2084\u2085\u2086\u2087\u2088\u2089');
  };

  /** m/s\u00b2 for m/s^2. */
  oddity.unitName = (unit) => (unit === '1' ? '' : unit.replace(/\^(\d)/g, (_, d) => '\u2070\u00b9\u00b2\u00b3\u2074'[d]));

  /** Names for 1 cm and 1 degree. */
  oddity.nameOfNeed = function (unit, allowed) {
    if (unit === 'm' && Math.abs(allowed - 0.01) < 1e-12) return '1 cm';
    if (unit === 'rad' && Math.abs(allowed - Math.PI / 180) < 1e-12) return '1\u00b0';
    return `${oddity.written(allowed)} ${unit}`.trim();
  };
})(window.oddity = window.oddity || {});
