// The shortest step that breaks a method, and a description of the result.

(function (oddity) {
  'use strict';

  const { written } = oddity;
  const finer = Math.pow(2, 1 / 4);

  /** A different motion: it breaks off, or its error is as large as the motion itself. */
  function broken(motions, parameters, row) {
    const motion = motions.run(parameters, row);
    const judged = motions.judge(motion, parameters);
    if (judged.broken !== null || motion.ending !== 'reached') return true;
    const sizes = oddity.sizes(motions.truth(parameters), motions.scene.norms, judged.units);
    return judged.worst.some((x, u) => x >= sizes[u]);
  }

  /** The shortest known unstable step, as a step that a trial can make. */
  function known(motions, parameters, row) {
    const limits = motions.data.stability ? motions.data.stability.limits : [];
    const limit = limits.find((l) => l.model === row.model && l.algorithm === row.algorithm);
    if (!limit || !limit.unstable || row.precision !== 'double' || !motions.isDefault(parameters)) return null;
    const interval = motions.scene.horizon / motions.looks;
    const steps = Math.floor(interval / limit.unstable * (1 + 1e-9));
    return steps > 0 ? { setting: interval / steps, limit } : null;
  }

  /** Outside the tolerance at some time. */
  function off(motions, parameters, row) {
    return motions.judge(motions.run(parameters, row), parameters).since !== null;
  }

  function searched(motions, parameters, row, resolution, fails) {
    const [from, to] = resolution === 'step' ? [motions.frame / 128, motions.scene.horizon / motions.looks] : [1e-12, 1];
    for (let tried = from; tried <= to * 1.001; tried *= resolution === 'step' ? finer : 10) {
      const setting = Number(tried.toPrecision(3));
      if (fails(motions, parameters, { ...row, setting })) return { setting };
    }
    return null;
  }

  function turns(motions, limit) {
    const unit = motions.scene.time_unit;
    if (limit.stable > 0) return `Up to ${written(limit.stable)} ${unit} a small disturbance does not grow. `;
    return 'No step is stable: whatever is disturbed grows, and here it shows. ';
  }

  /** Describes a motion in a sentence or two. */
  oddity.seen = function (motions, parameters, row) {
    const motion = motions.run(parameters, row);
    const judged = motions.judge(motion, parameters);
    const { text } = oddity.endingOf(motion, judged, motions.scene);
    const parts = [text];
    if (judged.broken === null) parts.push(`${oddity.amounts(judged.worst, judged.units)} off at worst`);
    const drift = oddity.largestDrift(motion);
    if (drift > 0.01 && judged.broken === null) parts.push(`a conserved quantity changes by ${oddity.part(drift)} ${drift >= 10 ? '' : 'of '}its moving part`);
    return parts.join('; ') + '.';
  };

  oddity.sentence = (text) => text.charAt(0).toUpperCase() + text.slice(1);

  /** {was, row, text} for the first row that has a step; {problem} if nothing breaks. */
  oddity.breaking = function (motions, parameters, rows) {
    const row = rows.find((r) => motions.find(r.model, r.algorithm).resolution && !motions.find(r.model, r.algorithm).path);
    if (!row) return { problem: 'None of these methods has a step that could be too long. Add one that has.' };
    const { resolution: kind } = motions.find(row.model, row.algorithm);
    const limit = kind === 'step' ? known(motions, parameters, row) : null;
    const broke = limit || searched(motions, parameters, row, kind, broken);
    const found = broke || searched(motions, parameters, row, kind, off);
    const name = oddity.sentence(`${row.algorithm} on ${row.model}`);
    if (!found) return { problem: `${name} stays close at every ${kind} that fits into the motion.` };
    const next = { ...row, setting: found.setting };
    const unit = kind === 'step' ? ` ${motions.scene.time_unit}` : '';
    const first = (limit ? turns(motions, found.limit) : broke ? '' : `No ${kind} that fits into the motion breaks it. `)
      + `${name} at a ${kind} of ${written(found.setting)}${unit}: `;
    return { was: row, row: next, text: first + oddity.seen(motions, parameters, next) };
  };
})(window.oddity = window.oddity || {});
