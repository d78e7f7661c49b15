// Searches for the cheapest method that is enough for a problem's file, in small pieces while one types.

(function (oddity) {
  'use strict';

  const steps = [1, 2, 4, 8, 16, 32, 64];     // per frame
  const tolerances = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10];
  const safe = 0.1;                           // relative to the need: the largest error of the truth

  const settingsOf = (motions, { resolution }) =>
    (resolution === 'step' ? steps.map((n) => motions.frame / n) : resolution === 'tolerance' ? tolerances : [0]);

  function settingText(motions, { algorithm, model, setting }) {
    const { resolution } = motions.find(model, algorithm);
    if (resolution === 'tolerance') return ` at a tolerance of ${oddity.written(setting)}`;
    if (resolution !== 'step') return '';
    const count = Math.round(motions.frame / setting);
    return count === 1 ? ' with a step a frame' : ` with ${count} steps a frame`;
  }

  /** The reason why no answer is possible; empty if one is. */
  function doubts(motions, parameters) {
    const { ending, message } = motions.truth(parameters);
    if (ending !== 'reached') return `No method is judged, as the true motion is not known to the end: ${message || ending}.`;
    const apart = motions.apart(parameters);
    const needs = apart.map((x, u) => x / motions.scene.close[motions.units[u]]);
    if (needs.every((x) => x <= safe)) return '';
    return `No method is judged, as the two routes to the truth differ by ${oddity.amounts(apart, motions.units)}: `
      + 'that is not far below the file\u2019s tolerance.';
  }

  function told(motions, best) {
    const { method, judged, motion } = best;
    const cost = motion.evaluations === 1 ? 'one evaluation' : `${motion.evaluations} evaluations`;
    const by = motions.find(method.model, method.algorithm).resolution ? `${oddity.sentence(method.algorithm)} on ${method.model}`
      : `The closed form of ${method.model}`;
    return `${by}${settingText(motions, method)} is enough: at ${motions.frames} frames${motions.part && `, the first ${motions.part},`} it is `
      + `${oddity.amounts(judged.worst, judged.units)} off at most, for ${cost}.`;
  }

  /** Yields {text, done} after each piece of work, the last with `done`. */
  oddity.enough = function* (motions, parameters) {
    const why = doubts(motions, parameters);
    if (why) return yield { text: why, done: true };
    let best = null;
    let tried = 0;
    const printed = new Map();              // the cheapest of each model that has code
    for (const found of motions.methods) {
      const prints = oddity.isPrintable(found.algorithm);
      for (const setting of settingsOf(motions, found)) {
        const method = { model: found.model, algorithm: found.algorithm, precision: 'double', setting };
        const { motion, judged } = motions.judgedByFrame(parameters, method);
        const isDearer = (than) => than && motion.evaluations >= than.motion.evaluations;
        const holds = motion.ending === 'reached' && judged.broken === null && judged.since === null;
        if (holds && !isDearer(best)) best = { method, motion, judged };
        if (holds && prints && !isDearer(printed.get(found.model))) printed.set(found.model, { method, motion, judged });
        if (holds || isDearer(prints ? printed.get(found.model) : best)) break;
      }
      tried += 1;
      yield { text: `${best ? told(motions, best) : 'Nothing is enough so far.'} ${tried} of ${motions.methods.length} methods are tried.`, done: false };
    }
    const need = oddity.needName(motions.scene.close);
    const programs = new Map([...printed].map(([model, one]) => [model, { method: one.method, says: told(motions, one) }]));
    yield { text: best ? `${told(motions, best)} Nothing that the page has is within ${need} for fewer.`
      : `Nothing that the page has is within ${need} up to ${steps[steps.length - 1]} steps a frame.`, done: true, best, programs };
  };
})(window.oddity = window.oddity || {});
