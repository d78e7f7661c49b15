// A table of numbers, as a spreadsheet writes it, as a part of a problem's file.

(function (oddity) {
  'use strict';

  const isRow = /^[\s"]*[-+]?\.?\d[\d.eE+\-\s,;"]*$/;

  /** "bump" of "bump (2).csv": a name that formulas can call. */
  oddity.nameOfTable = (file) => {
    const name = file.replace(/\.[^.]*$/, '').replace(/\W+/g, '_').replace(/^[\d_]+|_+$/g, '');
    return name || 'rows';
  };

  /** The file with the table behind it; headings and other lines without numbers are left out. */
  oddity.withTable = (file, name, lines) => {
    const rows = lines.split(/\r?\n/).filter((line) => isRow.test(line)).map((line) => line.replace(/"/g, '').trim());
    return `${file.trimEnd()}\n\n[tables.${name}]\nx = "s"          # the unit of the first column\ny = "m"          # the unit of the second\n`
      + `outside = "hold"\nrows = """\n${rows.join('\n')}\n"""\n`;
  };
})(window.oddity = window.oddity || {});
