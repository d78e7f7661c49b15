// A table of numbers, as a spreadsheet writes it, as a part of a problem's file.

(function (oddity) {
  'use strict';

  const number = /^[-+]?(\.?\d|(nan|inf|infinity)$)/i;
  const cells = (line) => line.split(/[\s,;]+/);

  /** "bump_2" of "bump (2).csv": a name that formulas can call, and that neither they nor the file have yet. */
  oddity.nameOfTable = (file, text) => {
    const base = file.replace(/\.[^.]*$/, '').replace(/\W+/g, '_').replace(/^[\d_]+|_+$/g, '') || 'rows';
    const taken = new Set([...text.match(/\w+/g) ?? [], ...oddity.takenNames]);
    let name = base;
    for (let i = 2; taken.has(name); i += 1) name = `${base}_${i}`;
    return name;
  };

  /** The file with the table behind it; headings and other lines without numbers are left out. */
  oddity.withTable = (file, name, lines) => {
    const rows = lines.replace(/["\\]/g, '').split(/\r\n?|\n/).map((line) => line.trim())
      .filter((line) => cells(line).some((cell) => number.test(cell)));
    return `${file.trimEnd()}\n\n[tables.${name}]\nx = "s"          # the unit of the first column\ny = "m"          # the unit of the second\n`
      + `outside = "hold"\nrows = """\n${rows.join('\n')}\n"""\n`;
  };
})(window.oddity = window.oddity || {});
