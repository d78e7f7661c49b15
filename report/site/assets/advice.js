// The chooser's answer in words.
(function (oddity) {
  'use strict';

  const { number, duration } = oddity.charts;
  const { sizes, unitsOf, inNeeds, pick, margin } = oddity.choosing;

  const settingOf = (row, fps) => {
    if (!row.resolution) return '';
    if (row.resolution === 'tolerance') return 'tolerance ' + number(row.setting, 1);
    const steps = Math.round(1 / (row.setting * fps));
    return steps + (steps === 1 ? ' step a frame' : ' steps a frame');
  };

  function errorIn(errors, state) {
    return unitsOf(state.scene)
      .map((unit) => {
        const [, symbol] = /^[0-9.]+(?:e[-+]?[0-9]+)?(.*)$/i.exec(state.errors[unit].text) || [];
        const size = symbol ? sizes[unit][symbol] : 1;
        const shown = symbol === 'deg' ? '°' : ' ' + (symbol || unit);
        return number(errors[unit] / size, 2) + shown;
      })
      .join(' and ');
  }

  const methodText = (row) =>
    (row.resolution ? row.algorithm : row.model + ' by ' + row.algorithm) +
    (row.precision === 'float' ? ' in float' : '') +
    (row.resolution ? ' on the model "' + row.model + '"' : '');

  const evaluationsText = (x) => number(x, 3) + (x === 1 ? ' evaluation' : ' evaluations');

  /** The answer in complete sentences. */
  function answer(state, found) {
    const chosen = pick(found.rows, state.budget ? state.budget.value : null);
    if (!chosen) {
      const held = found.rows.filter((r) => r.holds && !r.faulted).sort((a, b) => a.seconds - b.seconds)[0];
      if (held)
        return [
          'Nothing here holds within the budget.',
          'The nearest is ' + methodText(held) + ': ' + duration(1e9 * held.seconds) + ' a frame.',
        ];
      const best = [...found.rows].sort((a, b) => a.error - b.error)[0];
      return [
        'Nothing here meets that.',
        best && Number.isFinite(best.error)
          ? 'The closest is ' +
            methodText(best) +
            (best.resolution ? ', ' + settingOf(best, state.fps) : '') +
            ', with an error of ' +
            errorIn(best.errors, state) +
            '.'
          : '',
      ];
    }
    const { row, ties, simple } = chosen;
    const setting = settingOf(row, state.fps);
    const lines = [
      'Take ' +
        methodText(row) +
        (setting ? ', ' + setting : '') +
        ': ' +
        evaluationsText(row.evaluationsPerFrame) +
        ' and ' +
        duration(1e9 * row.seconds) +
        ' a frame in this page.',
    ];
    lines.push(
      'Its error is ' +
        errorIn(row.errors, state) +
        ' at most, ' +
        (row.error > 0 ? number(1 / row.error, 2) + ' times better than asked' : 'nothing that can be seen') +
        (simple ? '.' : '; nothing simpler holds with a margin of ' + margin + '.'),
    );
    lines.push(
      'It is the most accurate of ' +
        (simple ? 'the simple methods that hold with a margin of ' + margin : 'all that hold') +
        ' and take at most a quarter longer in this page than the fastest of them.',
    );
    const { truth } = found;
    if (row.model === truth.model && row.algorithm === truth.algorithm && row.precision === 'double')
      lines[1] =
        'This page takes it for the truth' +
        (truth.errors ? ', which is known to ' + errorIn(truth.errors, state) : '') +
        '.';
    if (state.budget)
      lines.push('Share of the budget: ' + number((100 * row.seconds) / state.budget.value, 2) + ' %.');
    const other = [...new Set(ties.map(methodText))].slice(0, 3);
    if (other.length) lines.push('It costs about the same as ' + other.join('; ') + '.');
    return lines;
  }

  const describe = (t, fps) =>
    '"' +
    t.model +
    '" by ' +
    t.algorithm +
    (t.setting >= 1e-10
      ? ', ' + Math.round(1 / (t.setting * fps)) + ' steps a frame'
      : t.setting
        ? ' at tolerance ' + number(t.setting, 1)
        : '');

  function truthText(state, truth) {
    const away = truth.errors
      ? '; ' + describe(truth.beside, state.fps) + ' is at most ' + errorIn(truth.errors, state) + ' from it'
      : '';
    const doubtful = truth.errors && inNeeds(truth.errors, state) > 0.1;
    return (
      'This page has no reference. It takes for the truth ' +
      describe(truth, state.fps) +
      away +
      '.' +
      (doubtful
        ? ' That is more than a tenth of the allowed error: the motion may be chaotic, and no answer here is safe.'
        : '') +
      ' This page tries one start. The command below uses references, on this start and on five near it.'
    );
  }

  oddity.choosing = Object.assign(oddity.choosing || {}, {
    settingOf,
    errorIn,
    answer,
    truthText,
  });
})((window.oddity = window.oddity || {}));
