// A model's code with a method's loop around it: a whole program of C++, as `choose --code` prints it.

(function (oddity) {
  'use strict';

  /** Nobody's text ends a comment, or a line of it. */
  const asComment = (text) => `// ${text.replace(/[\u0000-\u001f\u2028\u2029]+/g, ' ').replace(/\\+\s*$/, '')}\n`;
  const inString = (text) => text.replace(/[^\w .,()[\]^+*\/'-]/g, '_');

  /** Whether there is a loop for it. */
  oddity.isPrintable = (algorithm) => algorithm in oddity.programs;

  /** `method` is {model, algorithm, setting}; the result is empty where its model has no code. */
  oddity.wholeProgram = function (motions, parameters, method, says) {
    const model = oddity.engine.code(motions.models.indexOf(method.model), parameters);
    if (!model) return '';
    const { data, scene, frames, frame } = motions;
    const parts = { $model: model.trimEnd(), $names: ['t [s]', ...scene.observables.map(inString)].join(','), $frames: String(frames),
      $rate: String(Number((1 / frame).toPrecision(15))), $steps: String(Math.max(1, Math.round(frame / method.setting))) };
    const code = oddity.programs[method.algorithm].replace(/\$(model|names|frames|rate|steps)/g, (name) => parts[name]);
    return asComment(data.title) + asComment(says) + asComment('Compiled by c++ -std=c++20 -O2 it prints the observables at every frame.')
      + '\n' + code;
  };
})(window.oddity = window.oddity || {});
