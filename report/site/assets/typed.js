// Numbers in a field or a link, with a unit where one fits, as the program reads them.

(function (oddity) {
  'use strict';

  const decimal = '[+-]?(?:\\d+(?:\\.\\d*)?|\\.\\d+)(?:e[+-]?\\d+)?';
  const written = new RegExp(`^(${decimal})(?:\\s*/\\s*(${decimal}))?(?:\\s*([^\\s\\d.+-].*|1\\s*/.*))?$`, 'i');
  /** m/s2 for m/s^2 and m/s\u00b2. */
  const plain = (unit) => unit.replace(/[\s^\u00b7*]/g, '').replace(/^1\//, '/').replace(/[\u00b5\u03bc]/g, 'u')
    .replace(/\u00b2/g, '2').replace(/\u00b3/g, '3').replace(/\u00b0/g, 'deg');

  /** Throws a message for an invalid number. `sizes` are the accepted units: {name: its size in `unit`}. A
      comma may replace the point, and 1/60 is a number. */
  oddity.number = function (text, unit = '', sizes = {}) {
    const found = written.exec(text.trim().replace(/,/g, '.').replace(/\u2212/g, '-'));
    if (!found) throw new Error(`\u201c${text}\u201d is not a number`);
    const [, number, divisor, given = ''] = found;
    const fitting = Object.keys(sizes).filter((name) => plain(name) !== plain(unit));
    const known = given === '' || plain(given) === plain(unit) ? [1] : fitting.filter((name) => plain(name) === plain(given)).map((name) => sizes[name]);
    if (!known.length)
      throw new Error(`\u201c${text}\u201d has a unit that does not fit: ` +
        (unit && unit !== '1' ? `${[unit, ...fitting].join(', ')} do` : 'this number has none'));
    const x = (divisor === undefined ? Number(number) : Number(number) / Number(divisor)) * known[0];
    if (!Number.isFinite(x)) throw new Error(`\u201c${text}\u201d is not a number`);
    return x;
  };

  /** A number without units; null if invalid. */
  oddity.typed = function (text) {
    try {
      return oddity.number(text);
    } catch (error) {
      return null;
    }
  };

  /** The program as typed in a shell: the one that wrote this copy of the site, or the tree's. */
  oddity.program = (window.document && document.body.dataset.program) || './oddity';
})(window.oddity = window.oddity || {});
