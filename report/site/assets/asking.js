// The chooser's request: in its fields, in a link, and on the command line.
(function (oddity) {
  'use strict';

  const { number } = oddity.charts;

  const sizes = {
    m: { m: 1, cm: 0.01, mm: 0.001, km: 1000 },
    rad: { rad: 1, deg: Math.PI / 180, '°': Math.PI / 180 },
    s: { s: 1, ms: 1e-3, us: 1e-6, µs: 1e-6, ns: 1e-9, min: 60, h: 3600 },
  };

  const decimal = /^[-+]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:e[-+]?[0-9]+)?$/i;
  /** Accepts only decimals, as the program does; otherwise NaN. */
  const numeral = (text) => (decimal.test(text.trim()) ? Number(text) : NaN);

  /** "1 cm" as {value: 0.01, text: "1cm"} in the base unit; null if it is invalid or outside the limits. */
  function asked(text, base, least = 1e-24, most = 1e12) {
    const found = /^((?:[0-9]+(?:\.[0-9]+)?|\.[0-9]+)(?:e[-+]?[0-9]+)?)\s*((?:[^\s0-9.]\S*)?)$/i.exec(text.trim());
    if (!found) return null;
    const units = sizes[base] || {};
    const size = found[2] === '' || found[2] === base ? 1 : units[found[2]];
    const value = Number(found[1]) * size;
    if (!size || !(value >= least && value <= most)) return null;
    return { value, text: found[1] + (sizes[base] ? found[2].replace('°', 'deg').replace('µ', 'u') : '') };
  }

  const unitsOf = (scene) => Object.keys(scene.close);
  const usualError = (scene, unit) =>
    unit === 'm' ? '1 cm' : unit === 'rad' ? '1 deg' : String(Number(scene.close[unit].toPrecision(3)));

  /** The initial state of a page. */
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

  function valueOf(what, text, unit, { units = {} }) {
    try {
      return oddity.number(text, unit, units[unit]);
    } catch (error) {
      throw new Error(`${what}: ${error.message}`);
    }
  }

  function setParameter(state, p, text) {
    const value = valueOf(p.name, text, p.unit, state.scene);
    const least = p.least === null ? -Infinity : p.least,
      most = p.most === null ? Infinity : p.most;
    if (value < least || value > most)
      throw new Error(`${p.name} = ${text} is out of its range: ${number(least, 6)} to ${number(most, 6)}`);
    if (p.whole && !Number.isInteger(value)) throw new Error(`${p.name} is a whole number, not "${text}"`);
    state.parameters[p.name] = value;
  }

  function positive(state, key, text, says) {
    const unit = key === 'fps' ? `1/${state.scene.time_unit}` : state.scene.time_unit;
    const value = valueOf(says, text, unit, state.scene);
    if (!(value > 0)) throw new Error(`${says} is a number above zero, not "${text}"`);
    if (value < 1e-12 || value > 1e12) throw new Error(`${says} goes from 1e-12 to 1e12, and is not ${text}`);
    return value;
  }

  function requireFrames({ horizon, fps }) {
    const frames = horizon * fps;
    if (frames < 1) throw new Error('the horizon is shorter than a frame');
    if (frames > 1e6)
      throw new Error(`a horizon of ${horizon} at ${fps} has ${number(frames, 3)} frames, of at most a million`);
  }

  function setPositive(state, key, text, says) {
    const value = positive(state, key, text, says);
    requireFrames({ ...state, [key]: value });
    state[key] = value;
  }

  /** One number for all units, or one with a unit for each of them. */
  function setErrors(state, texts) {
    const units = unitsOf(state.scene);
    const refuse = (unit, text) => {
      const example = sizes[unit] ? ', such as 1 ' + Object.keys(sizes[unit])[1] : '';
      throw new Error(`an error in ${unit} is a number above zero${example}, not "${text}"`);
    };
    if (texts.length === 1 && !Number.isNaN(numeral(texts[0]))) {
      for (const unit of units) state.errors[unit] = asked(texts[0], unit) || refuse(unit, texts[0]);
      return;
    }
    const left = new Set(units);
    for (const text of texts) {
      const unit = Number.isNaN(numeral(text)) && units.find((one) => asked(text, one));
      if (!unit) refuse(units.length === 1 ? units[0] : units.join(' or '), text);
      if (!left.delete(unit)) throw new Error(`there are two errors in ${unit}`);
      state.errors[unit] = asked(text, unit);
    }
    if (left.size > 0) throw new Error(`an error is missing in ${[...left].join(', ')}`);
  }

  function setBudget(state, text) {
    if (text.trim() === '') {
      state.budget = null;
      return;
    }
    const found = Number.isNaN(numeral(text)) && asked(text, 's', 1e-12, 1e6);
    if (!found) throw new Error(`a budget is a time with its unit, such as 5us, not "${text}"`);
    state.budget = { value: found.value, text: found.text };
  }

  function setPrecision(state, text) {
    if (!['double', 'float', 'any'].includes(text))
      throw new Error(`a precision is double, float or any, not "${text}"`);
    state.precision = text;
  }

  /** The pendulum, as the best known scene. */
  const first = (scenes) => scenes.find((s) => s.number === '3.5') || scenes[0];

  /** The request in a link: "#scene=3.5&a=0.6&error=1deg". Throws a message for an invalid one. */
  function fromHash(hash, scenes) {
    const pairs = [...new URLSearchParams(hash.replace(/^#/, ''))];
    const wanted = new Map(pairs).get('scene');
    const scene = wanted === undefined ? first(scenes) : scenes.find((s) => s.number === wanted);
    if (!scene)
      throw new Error(`there is no scene "${wanted}"; there are ${scenes.map((s) => s.number).join(', ')}`);
    const state = usual(scene);
    const given = new Set();
    for (const [key, text] of pairs) {
      if (given.has(key)) throw new Error(`"${key}" is given twice`);
      given.add(key);
      const p = scene.parameters.find((parameter) => parameter.name === key);
      if (key === 'scene') continue;
      else if (key === 'horizon') state.horizon = positive(state, key, text, 'the horizon');
      else if (key === 'fps') state.fps = positive(state, key, text, 'the frame rate');
      else if (key === 'error') setErrors(state, text.split(','));
      else if (key === 'budget') setBudget(state, text);
      else if (key === 'precision') setPrecision(state, text);
      else if (p) setParameter(state, p, text);
      else throw new Error(`scene ${scene.number} has no parameter "${key}"`);
    }
    requireFrames(state);
    return state;
  }

  const changed = (state) =>
    state.scene.parameters
      .filter((p) => state.parameters[p.name] !== p.value)
      .map((p) => [p.name, String(state.parameters[p.name])]);
  /** Several errors have a unit each. */
  const errorText = (state) => {
    const units = unitsOf(state.scene);
    const withUnit = (text, unit) => (units.length > 1 && !Number.isNaN(numeral(text)) ? text + unit : text);
    return units.map((unit) => withUnit(state.errors[unit].text, unit)).join(',');
  };

  function toHash(state) {
    const pairs = [['scene', state.scene.number], ...changed(state), ['error', errorText(state)]];
    if (state.horizon !== 10) pairs.push(['horizon', String(state.horizon)]);
    if (state.fps !== 60) pairs.push(['fps', String(state.fps)]);
    if (state.budget) pairs.push(['budget', state.budget.text]);
    if (state.precision !== 'double') pairs.push(['precision', state.precision]);
    return '#' + new URLSearchParams(pairs);
  }

  /** The command that answers the same request, judged by references. */
  function command(state) {
    return [
      oddity.program + ' choose',
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
