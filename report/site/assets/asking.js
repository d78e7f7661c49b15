// What is asked of the chooser: in its fields, in a link, and on the command line.
(function (oddity) {
  'use strict';

  const { number } = oddity.charts;

  const sizes = {
    m: { m: 1, cm: 0.01, mm: 0.001, km: 1000 },
    rad: { rad: 1, deg: Math.PI / 180, '°': Math.PI / 180 },
    s: { s: 1, ms: 1e-3, us: 1e-6, µs: 1e-6, ns: 1e-9, min: 60, h: 3600 },
  };

  /** "1 cm" as {value: 0.01, text: "1cm"} in the base unit; null where it makes no sense. */
  function asked(text, base) {
    const found = /^((?:[0-9]+(?:\.[0-9]+)?|\.[0-9]+)(?:e[-+]?[0-9]+)?)\s*((?:[^\s0-9.]\S*)?)$/i.exec(text.trim());
    if (!found) return null;
    const units = sizes[base] || {};
    const size = found[2] === '' || found[2] === base ? 1 : units[found[2]];
    const value = Number(found[1]) * size;
    if (!size || !(value > 0) || !Number.isFinite(value)) return null;
    return { value, text: found[1] + (sizes[base] ? found[2].replace('°', 'deg').replace('µ', 'u') : '') };
  }

  const unitsOf = (scene) => Object.keys(scene.close);
  const usualError = (scene, unit) =>
    unit === 'm' ? '1 cm' : unit === 'rad' ? '1 deg' : String(Number(scene.close[unit].toPrecision(3)));

  /** What a page begins with. */
  function usual(scene) {
    return {
      scene,
      parameters: Object.fromEntries(scene.parameters.map((p) => [p.name, p.value])),
      horizon: 10,
      fps: 60,
      errors: Object.fromEntries(unitsOf(scene).map((unit) => [unit, asked(usualError(scene, unit), unit)])),
      budget: null,
      precision: 'double',
    };
  }

  function setParameter(state, p, text) {
    const value = Number(text);
    const least = p.least === null ? -Infinity : p.least,
      most = p.most === null ? Infinity : p.most;
    if (text.trim() === '' || !Number.isFinite(value))
      throw new Error(`${p.name} is a number, not "${text}"`);
    if (value < least || value > most)
      throw new Error(`${p.name} = ${text} is out of its range: ${number(least, 6)} to ${number(most, 6)}`);
    if (p.whole && !Number.isInteger(value)) throw new Error(`${p.name} is a whole number, not "${text}"`);
    state.parameters[p.name] = value;
  }

  function setPositive(state, key, text, says) {
    const value = Number(text);
    if (text.trim() === '' || !(value > 0) || !Number.isFinite(value))
      throw new Error(`${says} is a number above zero, not "${text}"`);
    state[key] = value;
  }

  function setErrors(state, texts) {
    unitsOf(state.scene).forEach((unit, i) => {
      const found = asked(texts.length === 1 ? texts[0] : texts[i] || '', unit);
      if (!found)
        throw new Error(
          `an error in ${unit} is a number above zero${sizes[unit] ? ', such as 1 ' + Object.keys(sizes[unit])[1] : ''}, not "${texts[i] || texts[0]}"`,
        );
      state.errors[unit] = found;
    });
  }

  function setBudget(state, text) {
    if (text.trim() === '') {
      state.budget = null;
      return;
    }
    const found = asked(text, 's');
    if (!found) throw new Error(`a budget is a time, such as 5us, not "${text}"`);
    state.budget = { value: found.value, text: found.text };
  }

  function setPrecision(state, text) {
    if (!['double', 'float', 'any'].includes(text))
      throw new Error(`a precision is double, float or any, not "${text}"`);
    state.precision = text;
  }

  /** The pendulum, which everybody knows. */
  const first = (scenes) => scenes.find((s) => s.number === '3.5') || scenes[0];

  /** What a link asks for: "#scene=3.5&a=0.6&error=1deg". Throws what is wrong with it. */
  function fromHash(hash, scenes) {
    const pairs = [...new URLSearchParams(hash.replace(/^#/, ''))];
    const wanted = new Map(pairs).get('scene');
    const scene = wanted === undefined ? first(scenes) : scenes.find((s) => s.number === wanted);
    if (!scene)
      throw new Error(`there is no scene "${wanted}"; there are ${scenes.map((s) => s.number).join(', ')}`);
    const state = usual(scene);
    for (const [key, text] of pairs) {
      const p = scene.parameters.find((parameter) => parameter.name === key);
      if (key === 'scene') continue;
      else if (key === 'horizon') setPositive(state, 'horizon', text, 'the horizon');
      else if (key === 'fps') setPositive(state, 'fps', text, 'the frame rate');
      else if (key === 'error') setErrors(state, text.split(','));
      else if (key === 'budget') setBudget(state, text);
      else if (key === 'precision') setPrecision(state, text);
      else if (p) setParameter(state, p, text);
      else throw new Error(`scene ${scene.number} has no parameter "${key}"`);
    }
    return state;
  }

  const changed = (state) =>
    state.scene.parameters
      .filter((p) => state.parameters[p.name] !== p.value)
      .map((p) => [p.name, String(state.parameters[p.name])]);
  const errorText = (state) =>
    unitsOf(state.scene)
      .map((unit) => state.errors[unit].text)
      .join(',');

  function toHash(state) {
    const pairs = [['scene', state.scene.number], ...changed(state), ['error', errorText(state)]];
    if (state.horizon !== 10) pairs.push(['horizon', String(state.horizon)]);
    if (state.fps !== 60) pairs.push(['fps', String(state.fps)]);
    if (state.budget) pairs.push(['budget', state.budget.text]);
    if (state.precision !== 'double') pairs.push(['precision', state.precision]);
    return '#' + new URLSearchParams(pairs);
  }

  /** The command whose answer is judged by references. */
  function command(state) {
    return [
      'oddity choose',
      state.scene.number,
      ...changed(state).map(([name, value]) => name + '=' + value),
      '--error ' + errorText(state),
      '--horizon ' + state.horizon,
      '--fps ' + state.fps,
      ...(state.budget ? ['--budget ' + state.budget.text] : []),
      ...(state.precision !== 'double' ? ['--precision ' + state.precision] : []),
    ].join(' ');
  }

  oddity.choosing = Object.assign(oddity.choosing || {}, {
    sizes,
    asked,
    unitsOf,
    usual,
    setParameter,
    setPositive,
    setBudget,
    setPrecision,
    first,
    fromHash,
    errorText,
    toHash,
    command,
  });
})((window.oddity = window.oddity || {}));
