// Motions as frames: a motion is {times, observed, count}, with the observables time after time.

(function (oddity) {
  'use strict';

  const viewOf = (base64) => new DataView(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer);

  /** Floats, least byte first, in base64. */
  oddity.floats = function (base64) {
    const view = viewOf(base64);
    return Float64Array.from({ length: view.byteLength / 4 }, (_, i) => view.getFloat32(4 * i, true));
  };

  /** Whole numbers of 16 bits, least byte first, in base64. */
  oddity.wholes = function (base64) {
    const view = viewOf(base64);
    return Float64Array.from({ length: view.byteLength / 2 }, (_, i) => view.getUint16(2 * i, true));
  };

  /** Whole numbers of 16 bits from base64 of their changes from frame to frame, `count` in each: all low
      bytes, then all high bytes. */
  oddity.fromChanges = function (base64, count) {
    const view = viewOf(base64);
    const size = view.byteLength / 2;
    const values = new Float64Array(size);
    for (let i = 0; i < size; i += 1)
      values[i] = ((i < count ? 0 : values[i - count]) + view.getUint8(i) + 256 * view.getUint8(size + i)) % 65536;
    return values;
  };

  /** 0, frame, 2 frame, ..., horizon. */
  oddity.frameTimes = function (horizon, frames) {
    return Float64Array.from({ length: frames + 1 }, (_, i) => horizon * i / frames);
  };

  /** The steps of a trial: each interval between judged times is divided evenly into steps no longer than
      asked. Also the times to show: every step, or at least once a frame if steps are shorter. */
  oddity.stepTimes = function (horizon, looks, frame, asked) {
    const interval = horizon / looks;
    const steps = Math.max(1, Math.ceil(interval / asked * (1 - 1e-12)));
    const step = interval / steps;
    const every = Math.max(1, Math.floor(frame / step * (1 + 1e-9)));
    const times = [0];
    for (let look = 0; look < looks; look += 1) {
      for (let i = every; i < steps; i += every) times.push(look * interval + i * step);
      times.push(horizon * (look + 1) / looks);
    }
    return { step, times: Float64Array.from(times) };
  };

  /** How the frames of a game come: the first is how they do unless asked otherwise. */
  oddity.framesAs = [
    { name: 'even', says: 'all of one length', jitter: 0, drop: 0 },
    { name: 'jitter', says: 'each up to 20 % longer or shorter', jitter: 0.2, drop: 0 },
    { name: 'drop', says: 'one in twenty dropped', jitter: 0, drop: 0.05 },
    { name: 'both', says: 'up to 50 % longer or shorter, one in twenty dropped', jitter: 0.5, drop: 0.05 },
  ];

  /** The steps where frames come so, the same at every call: each frame, of whatever length, is divided into as
      many as the usual one. */
  oddity.unevenTimes = function (horizon, frame, asked, { jitter, drop }) {
    const steps = Math.max(1, Math.round(frame / asked));
    const times = [0];
    let seed = 1;
    const random = () => { seed = seed * 48271 % 2147483647; return seed / 2147483647; };
    let longest = 0;
    for (let begin = 0, length = 0; begin < horizon;) {
      length += frame * (1 + jitter * (2 * random() - 1));
      if (random() < drop) continue;
      const end = Math.min(horizon, begin + length);
      for (let i = 1; i < steps; i += 1) times.push(begin + (end - begin) * i / steps);
      times.push(end);
      longest = Math.max(longest, (end - begin) / steps);
      begin = end;
      length = 0;
    }
    return { step: longest * (1 + 1e-9), times: Float64Array.from(times) };
  };

  oddity.timesOfSteps = (horizon, looks, frame, asked, as = oddity.framesAs[0]) => (as === oddity.framesAs[0]
    ? oddity.stepTimes(horizon, looks, frame, asked) : oddity.unevenTimes(horizon, frame, asked, as));

  /** The last place whose time is not after t. */
  oddity.placeOf = function (times, t) {
    let low = 0;
    let high = times.length - 1;
    const soon = t + 1e-9 * times[high];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle] <= soon) low = middle;
      else high = middle - 1;
    }
    return low;
  };

  const seenAt = (motion, i) => motion.observed.subarray(i * motion.count, (i + 1) * motion.count);
  const known = (observed) => observed.every(Number.isFinite);

  /** The observables at t, linear between frames; where the motion breaks off, its last frame. */
  oddity.between = function (motion, t) {
    const { times } = motion;
    let i = oddity.placeOf(times, t);
    while (i > 0 && !known(seenAt(motion, i))) i -= 1;
    const here = seenAt(motion, i);
    if (i + 1 >= times.length || t <= times[i]) return here;
    const next = seenAt(motion, i + 1);
    if (!known(next) || !known(here)) return known(here) ? here : next;
    const part = Math.min(1, (t - times[i]) / (times[i + 1] - times[i]));
    return here.map((x, k) => x + part * (next[k] - x));
  };

  /** The observables at t by the polynomial through the six nearest frames. */
  oddity.throughSix = function (motion, t) {
    const { times, count } = motion;
    const last = times.length - 1;
    const i = oddity.placeOf(times, t);
    if (Math.abs(times[i] - t) <= 1e-9 * times[last]) return seenAt(motion, i);
    const start = known(seenAt(motion, 0)) ? 0 : 1;
    const from = Math.max(start, Math.min(i - 2, last - 5));
    const to = Math.min(last, from + 5);
    const sum = new Float64Array(count);
    for (let j = from; j <= to; j += 1) {
      let weight = 1;
      for (let k = from; k <= to; k += 1)
        if (k !== j) weight *= (t - times[k]) / (times[j] - times[k]);
      const frame = seenAt(motion, j);
      for (let k = 0; k < count; k += 1) sum[k] += weight * frame[k];
    }
    return sum;
  };

  /** The distance of two places in each unit: each norm's components are one point or one angle. */
  oddity.distances = function (seen, truth, norms, units) {
    const far = units.map(() => 0);
    for (const { unit, components } of norms) {
      const apart = Math.hypot(...components.map((k) => seen[k] - truth[k]));
      const place = units.indexOf(unit);
      if (Number.isNaN(apart) || apart > far[place]) far[place] = apart;
    }
    return far;
  };

  /** Judges a motion against the truth. Gives at each of its times the distance in each unit and in needs,
      NaN if one of the two is unknown. Also gives the worst of each, since when it fails, when it breaks off,
      and the number of times judged. `close` is the tolerance by unit. */
  oddity.judged = function (motion, truth, norms, close) {
    const units = Object.keys(close);
    const n = motion.times.length;
    const all = { units, errors: units.map(() => new Float64Array(n).fill(NaN)), needs: new Float64Array(n).fill(NaN),
      worst: units.map(() => 0), since: null, broken: null, count: 0 };
    for (let i = 0; i < n; i += 1) {
      const here = seenAt(motion, i);
      if (!known(here)) {
        if (i === 0) continue;
        all.broken = motion.times[i];
        if (all.since === null) all.since = all.broken;
        break;
      }
      const far = oddity.distances(here, oddity.throughSix(truth, motion.times[i]), norms, units);
      if (far.some(Number.isNaN)) continue;
      all.count += 1;
      all.needs[i] = Math.max(...far.map((x, u) => x / close[units[u]]));
      far.forEach((x, u) => {
        all.errors[u][i] = x;
        if (x > all.worst[u]) all.worst[u] = x;
      });
      if (all.since === null && all.needs[i] > 1) all.since = motion.times[i];
    }
    return all;
  };

  /** The largest distance of a motion from its zero, in each unit. */
  oddity.sizes = function (motion, norms, units) {
    const zero = new Float64Array(motion.count);
    const sizes = units.map(() => 0);
    for (let i = 0; i < motion.times.length; i += 1)
      oddity.distances(seenAt(motion, i), zero, norms, units)
        .forEach((x, u) => { if (x > sizes[u]) sizes[u] = x; });
    return sizes;
  };
})(window.oddity = window.oddity || {});
