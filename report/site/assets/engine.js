// oddity.engine: the scenes' models, compiled from the program's own C++ to WebAssembly (report/site/module).
//
// - ready: resolves to whether the models can be run. They are in models.js, which is loaded later.
// - algorithms: `[{name, kind, order, resolution, inFloat}]`. `kind` is fixed, partitioned, velocities first, controlled,
//   implicit fixed, implicit controlled or closed form. `resolution` is step or tolerance, and empty for a closed form.
// - scene(number): null for an unknown scene, otherwise
//     `{parameters: [name], defaults: {name: value}, models: [{name, algorithms: [name], constrained, events}],
//     observables: their number, drawn, space}`. A model with events runs in double only.
// - run: takes `{scene, parameters, model, algorithm, precision: 'double' | 'float', setting, times}`, where `times[0]`
//   is 0. Returns `{observed, drift, off, evaluations, ending, message, seconds, last}`:
//   - observed: the observables time after time, NaN from the break-off on.
//   - drift: at each time, the change of conserved quantities relative to their moving parts; or empty.
//   - off: at each time, the distance from the constraint in m; or empty.
//   - ending: reached, non-finite, stalled, raised, chattering or grazing.
//   - last: the observables where the motion broke off, otherwise null.
// - draw(number, parameters, t, observed): null if the scene defines no drawing, otherwise
//     `{space, primitives: [{kind, points: [[x, y, z]], size, letter, trail}]}`.
//
// Omitted parameters have their defaults. The module that reads problems' files (own.js) has no scene at first, and
// three more functions:
//
// - take(text): resolves to `{file}`, the text as understood, and makes its scene 'own'. A faulty text leaves the scene
//   as before and gives `{wrong: {line, column, reason, message}}`, with line and column 0 if the place is not known.
// - code(model, parameters): C++ of the file's model with this index, made by oddity::asked::model(); or nothing if it
//   cannot be printed.
// - claim(place): judgement of the file's claim with this index, or `{wrong}`:
//     `{says, printed, verdict, expected, why, checks: [{reading, holds, text, where}]}`.
(function (oddity) {
  'use strict';

  const endings = ['reached', 'non-finite', 'stalled', 'raised', 'chattering', 'grazing'];
  const closedForm = {name: 'closed form', kind: 'closed form', order: 0, resolution: '', inFloat: true};

  let compiled = null;
  let wasm = null;        // the module's exports
  let scenes = new Map();
  let kinds = [];         // names of the kinds of primitives
  let answer;
  const ready = new Promise(resolve => { answer = resolve; });

  // ---- the module ---------------------------------------------------------------------------------------------

  function bytesOf(base64) {
    return Uint8Array.from(atob(base64), letter => letter.charCodeAt(0));
  }

  async function unpacked(bytes) {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
    return new Response(stream).arrayBuffer();
  }

  // The C library needs a system for printing and exiting; it gets none.
  function noSystem(module) {
    const imports = {};
    for (const wanted of WebAssembly.Module.imports(module)) {
      imports[wanted.module] = imports[wanted.module] || {};
      imports[wanted.module][wanted.name] = () => 52;  // "no such function"
    }
    return imports;
  }

  async function begin() {
    const instance = await WebAssembly.instantiate(compiled, noSystem(compiled));
    wasm = instance.exports;
    wasm._initialize();
    describe(JSON.parse(text(wasm.describe())));
  }

  async function start(base64) {
    compiled = await WebAssembly.compile(await unpacked(bytesOf(base64)));
    await begin();
  }

  oddity.module = function (base64) {
    if (base64 === null) return answer(false);
    start(base64).then(() => answer(true), () => { wasm = null; answer(false); });
  };

  // ---- description
  // --------------------------------------------------------------------------------------------

  function describe(all) {
    engine.algorithms = all.algorithms.concat([closedForm]);
    kinds = all.kinds;
    scenes = new Map();
    all.scenes.forEach((scene, index) => scenes.set(scene.number, known(scene, index)));
  }

  function known(scene, index) {
    const values = numbers(wasm.defaults(index), scene.parameters.length);
    const models = scene.models.map(model => ({
      name: model.name, algorithms: algorithmsOf(model), constrained: model.constrained, events: model.events
    }));
    const whole = {
      index, parameters: scene.parameters, models, observables: scene.observables, drawn: scene.drawn, space: false,
      defaults: Object.fromEntries(scene.parameters.map((name, i) => [name, values[i]]))
    };
    if (scene.drawn) whole.space = drawing(whole, {}, 0, new Array(scene.observables).fill(0)).space;
    return whole;
  }

  function algorithmsOf(model) {
    if (model.closedForm) {
      const own = model.algorithm || closedForm.name;
      if (!engine.algorithms.some(a => a.name === own)) engine.algorithms.push(Object.assign({}, closedForm, {name: own}));
      return [own];
    }
    return engine.algorithms
      .filter(a => a.kind !== closedForm.kind && (a.kind !== 'partitioned' || model.partitioned) &&
        (a.kind !== 'velocities first' || model.velocities))
      .map(a => a.name);
  }

  // ---- memory, in which the module reads and writes -----------------------------------------------------------

  function numbers(address, count) {
    return new Float64Array(wasm.memory.buffer, address, count).slice();
  }

  const decoder = new TextDecoder();

  function text(address, length) {
    if (length === 0) return '';
    const bytes = new Uint8Array(wasm.memory.buffer);
    const end = length === undefined ? bytes.indexOf(0, address) : address + length;
    return decoder.decode(bytes.subarray(address, end));
  }

  function put(values) {
    const address = wasm.input(values.length);
    new Float64Array(wasm.memory.buffer, address, values.length).set(values);
    return address;
  }

  // A string for the duration of a call.
  function withText(string, call) {
    const bytes = new TextEncoder().encode(string + '\0');
    const address = wasm.malloc(bytes.length);
    new Uint8Array(wasm.memory.buffer).set(bytes, address);
    const result = call(address);
    wasm.free(address);
    return result;
  }

  function valuesOf(scene, parameters) {
    return scene.parameters.map(name => (name in parameters ? parameters[name] : scene.defaults[name]));
  }

  // An exception ends the call without unwinding; restores the stack pointer.
  function guarded(call, otherwise) {
    const stack = wasm.__stack_pointer.value;
    try {
      return call();
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError)) throw error;
      wasm.__stack_pointer.value = stack;
      return otherwise(error.message);
    }
  }

  // ---- a motion -----------------------------------------------------------------------------------------------

  function filled(address, states, each, times) {
    const all = new Float64Array(times * each).fill(NaN);
    if (states > 0) all.set(numbers(address, states * each));
    return all;
  }

  function nothing(scene, asked, ending, message) {
    return {
      observed: new Float64Array(asked.times.length * scene.observables).fill(NaN), drift: new Float64Array(0),
      off: new Float64Array(0), evaluations: 0, ending, message, seconds: 0, last: null
    };
  }

  function collected(scene, states, times, seconds) {
    const whole = wasm.whole();
    const observed = filled(wasm.observed(), whole, scene.observables, times);
    const last = whole === states ? null
      : numbers(wasm.observed() + 8 * whole * scene.observables, scene.observables);
    const optional = address => (address ? filled(address, whole, 1, times) : new Float64Array(0));
    return {
      observed, drift: optional(wasm.drift()), off: optional(wasm.off()), evaluations: wasm.evaluations(),
      ending: endings[wasm.ending()], message: text(wasm.message()), seconds, last
    };
  }

  function run(asked) {
    const scene = scenes.get(asked.scene);
    const model = scene.models.findIndex(m => m.name === asked.model && m.algorithms.includes(asked.algorithm));
    if (model < 0) return nothing(scene, asked, 'raised', 'the module does not have this method');
    return guarded(() => {
      put(valuesOf(scene, asked.parameters || {}).concat(Array.from(asked.times)));
      const before = performance.now();
      const states = withText(asked.algorithm, algorithm =>
        wasm.run(scene.index, model, algorithm, asked.precision === 'float', asked.setting));
      return collected(scene, states, asked.times.length, (performance.now() - before) / 1000);
    }, message => nothing(scene, asked, 'raised', message));
  }

  // ---- a problem's file ---------------------------------------------------------------------------------------

  let taken = null;       // the last valid text

  function takenBy(module, string) {
    const bytes = new TextEncoder().encode(string);
    const address = module.malloc(bytes.length + 1);
    new Uint8Array(module.memory.buffer).set(bytes, address);
    const result = JSON.parse(text(module.take(address, bytes.length)));
    module.free(address);
    if (result.file) describe(JSON.parse(text(module.describe())));
    return result;
  }

  // Deep nesting or lack of memory ends the module: loads a new one with the previous text.
  async function take(string) {
    try {
      const result = takenBy(wasm, string);
      if (result.file) taken = string;
      return result;
    } catch (error) {
      await begin();
      if (taken !== null) takenBy(wasm, taken);
      const reason = 'this is more than the page can read';
      return {wrong: {line: 0, column: 0, reason, message: reason}};
    }
  }

  // ---- a drawing ----------------------------------------------------------------------------------------------

  // Called hundreds of times whenever a parameter moves: plain loops, as destructuring takes many times as
  // long.
  function drawing(scene, parameters, t, observed) {
    put(valuesOf(scene, parameters).concat([t], Array.from(observed)));
    const address = guarded(() => wasm.draw(scene.index), () => 0);
    if (!address) return null;
    const all = new Float64Array(wasm.memory.buffer, address);
    const primitives = new Array(all[1]);
    let at = 2;
    for (let i = 0; i < primitives.length; ++i) {
      const points = new Array(all[at + 5]);
      const letter = text(all[at + 3], all[at + 4]);
      primitives[i] = {kind: kinds[all[at]], points, size: all[at + 1], letter, trail: all[at + 2] === 1};
      at += 6;
      for (let k = 0; k < points.length; ++k, at += 3) points[k] = [all[at], all[at + 1], all[at + 2]];
    }
    return {space: all[0] === 1, primitives};
  }

  const engine = oddity.engine = {
    ready,
    algorithms: [],
    scene: number => scenes.get(number) || null,
    run,
    take,
    code: (model, parameters) => text(wasm.code(model, put(valuesOf(scenes.get('own'), parameters)))),
    claim: place => guarded(() => JSON.parse(text(wasm.claim(place))), wrong => ({wrong})),
    draw: (number, parameters, t, observed) =>
      scenes.has(number) ? drawing(scenes.get(number), parameters, t, observed) : null
  };
})(window.oddity = window.oddity || {});
