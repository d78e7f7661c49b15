// A player's state as the part of an address after #, and back. The input is untrusted: its parts are checked
// against the scene before use.
//   #play&p.a=0.6&row=one%20angle/explicit%20Euler/double/0.0167&at=1.5&speed=0.25&view=30,22.5

(function (oddity) {
  'use strict';

  const most = 4;
  const word = encodeURIComponent;

  class Unreadable extends Error {}

  function readable(text) {
    try {
      return decodeURIComponent(text.replace(/\+/g, ' '));
    } catch (error) {
      throw new Unreadable('The link is damaged.');
    }
  }

  function number(text, what, unit, units) {
    try {
      return oddity.number(text, unit, units);
    } catch (error) {
      throw new Unreadable(`The link has for ${what} what it cannot be: ${error.message}.`);
    }
  }

  function parameter(name, text, known) {
    const found = known.parameters.find((p) => p.name === name);
    if (!found) throw new Unreadable(`The link sets \u201c${name}\u201d, which ${known.missing}.`);
    const x = number(text, name, found.unit, known.units && known.units[found.unit]);
    const low = Number.isFinite(found.least) && x < found.least;
    const high = Number.isFinite(found.most) && x > found.most;
    if (low || high || (found.whole && !Number.isInteger(x)))
      throw new Unreadable(`The link sets ${name} to ${text}; it goes from ${found.least} to ${found.most}.`);
    return x;
  }

  function row(text, known) {
    const [model, algorithm, precision, setting, ...more] = text.split('/').map(readable);
    if (setting === undefined || more.length) throw new Unreadable('The link names a method that is not one of four parts.');
    const found = known.methods.find((m) => m.model === model && m.algorithm === algorithm);
    if (!found) throw new Unreadable(`The link asks for \u201c${model}, ${algorithm}\u201d, which ${known.missing}.`);
    if (!found.precisions.includes(precision))
      throw new Unreadable(`The link asks for ${algorithm} in \u201c${precision}\u201d, which it cannot do.`);
    const x = number(setting, found.resolution || 'a setting');
    if (found.resolution && !(x > 0)) throw new Unreadable(`The link sets a ${found.resolution} of ${setting}; it has to be above 0.`);
    return { model, algorithm, precision, setting: x };
  }

  function view(text, known) {
    if (!known.space) throw new Unreadable('The link turns the scene, which lies in a plane.');
    const [azimuth, elevation, ...more] = text.split(',').map((x) => number(x, 'the view'));
    if (elevation === undefined || more.length || Math.abs(elevation) > 90)
      throw new Unreadable(`The link has \u201c${text}\u201d for the view, which is not an azimuth and an elevation in degrees.`);
    return { azimuth, elevation };
  }

  function state(parts, known) {
    const read = { parameters: {}, rows: [], time: 0, speed: 1 };
    const given = new Set();
    for (const part of parts) {
      const [name, text = ''] = part.split(/=(.*)/s);
      if (name !== 'row' && given.has(readable(name))) throw new Unreadable(`The link says \u201c${readable(name)}\u201d twice.`);
      given.add(readable(name));
      if (name.startsWith('p.')) {
        const key = readable(name.slice(2));
        read.parameters[key] = parameter(key, readable(text), known);
      } else if (name === 'row') {
        read.rows.push(row(text, known));
      } else if (name === 'view') {
        read.view = view(readable(text), known);
      } else if (name === 'at') {
        read.time = Math.min(known.horizon, Math.max(0, number(readable(text), 'the time')));
      } else if (name === 'speed') {
        read.speed = number(readable(text), 'the speed');
        if (!known.speeds.includes(read.speed)) throw new Unreadable(`The link asks for a speed of ${read.speed}.`);
      } else if (name === 'frames') {
        read.as = oddity.framesAs.find((as) => as.name === readable(text));
        if (!read.as) throw new Unreadable(`The link asks for frames that come as \u201c${readable(text)}\u201d, which the player does not know.`);
      } else {
        throw new Unreadable(`The link says \u201c${readable(name)}\u201d, which the player does not know.`);
      }
    }
    if (read.rows.length > most) throw new Unreadable(`The link names ${read.rows.length} methods; ${most} can be shown.`);
    return read;
  }

  oddity.permalink = {
    /** Link to a player in the state `{parameters: {name: value}, rows: [{model, algorithm, precision, setting}],
        time, speed, view}`. The view, `{azimuth, elevation}` in degrees, may be missing. */
    format({ parameters, rows, time, speed, view, as }) {
      const parts = ['#play'];
      for (const [name, value] of Object.entries(parameters)) parts.push(`p.${word(name)}=${word(value)}`);
      for (const r of rows)
        parts.push('row=' + [r.model, r.algorithm, r.precision, r.setting].map((x) => word(x)).join('/'));
      if (time) parts.push(`at=${Number(time.toFixed(6))}`);
      if (speed !== 1) parts.push(`speed=${speed}`);
      if (as && as !== oddity.framesAs[0]) parts.push(`frames=${as.name}`);
      if (view) parts.push(`view=${word(view.azimuth)},${word(view.elevation)}`);  // 1e+30 has a plus
      return parts.join('&');
    },

    /** `{state}`, or `{problem: a sentence}`; null if it is no link to a player. `known` is `{parameters,
        methods: [{model, algorithm, precisions, resolution}], horizon, speeds, space: whether the view can turn,
        missing: the message for a missing part}`. */
    parse(hash, known) {
      const [first, ...parts] = hash.split('&');
      if (first !== '#play' || !parts.length) return null;     // #play is the player's own place in the page
      try {
        return { state: state(parts, known) };
      } catch (error) {
        if (error instanceof Unreadable) return { problem: error.message };
        throw error;
      }
    },
  };
})(window.oddity = window.oddity || {});
