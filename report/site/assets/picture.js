// The picture of a player: the scene with the truth as a ghost, and each method with its trail.

(function (oddity) {
  'use strict';

  const looks = 40;        // times of the motion, to fit it into the stage
  const beyond = 0.4;      // relative to the truth's size: how far a method may go and still be fitted in

  const pointsOf = (drawing) => drawing.primitives.flatMap((p) => p.points);

  /** The points that the stage has to show: the truth, and the methods while they are not far off. */
  function toFit(truth, others) {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (const drawing of truth)
      for (const p of pointsOf(drawing))
        for (let k = 0; k < 3; k += 1) {
          if (p[k] < low[k]) low[k] = p[k];
          if (p[k] > high[k]) high[k] = p[k];
        }
    const far = beyond * Math.hypot(...high.map((x, k) => x - low[k]));
    const near = (p) => p.every((x, k) => x >= low[k] - far && x <= high[k] + far);
    return [...truth, ...others.filter((drawing) => pointsOf(drawing).every(near))];
  }

  const farthest = 30; // times the truth's size, how far a view follows

  /** A box about points, wider by so much of its size. */
  function box(drawings, share) {
    const all = drawings.flatMap(pointsOf);
    const low = [0, 1, 2].map((k) => Math.min(...all.map((p) => p[k]))), high = [0, 1, 2].map((k) => Math.max(...all.map((p) => p[k])));
    const room = share * Math.hypot(...high.map((x, k) => x - low[k]));
    return (p) => p.every((x, k) => x >= low[k] - room && x <= high[k] + room);
  }

  const trailing = (drawing) => drawing.primitives.filter((p) => p.trail).map((p) => p.points[0]);

  oddity.picture = function (canvas, motions) {
    const stage = oddity.stage(canvas, { space: motions.space });
    const { horizon } = motions.scene;
    let parameters = motions.defaults;
    let within = () => true, reachable = () => true;
    let layers = [];     // {motion, see, colour, ghost, way}, the truth first

    function draw({ motion, see }, t) {
      const observed = see(motion, t);
      return observed.every(Number.isFinite) ? motions.drawing(parameters, t, observed) : null;
    }

    function all(layer) {
      return Array.from({ length: looks + 1 }, (_, i) => draw(layer, horizon * i / looks)).filter((d) => d);
    }

    /** The paths of the bodies with a trail, updated once a frame. */
    function trails(layer, t, now) {
      const { times } = layer.motion;
      const last = oddity.placeOf(times, t);
      for (let i = layer.way.length; i <= last; i += 1) {
        const drawing = draw(layer, times[i]);
        layer.way.push(drawing ? trailing(drawing) : []);
      }
      return now.map((point, k) => {
        const trail = [];
        for (let i = 0; i <= last; i += 1) if (layer.way[i][k]) trail.push(layer.way[i][k]);
        trail.push(point);
        return trail;
      });
    }

    function seenAt(layer, t) {
      const drawing = draw(layer, t);
      if (!drawing) return null;
      const { colour, ghost } = layer;
      const ways = trails(layer, t, trailing(drawing));
      return { drawing, colour, ghost, trail: ways[0] || [], trails: ways };
    }

    return {
      /** `methods`: [{motion, colour}]. */
      show(given, truth, ghostColour, methods) {
        parameters = given;
        layers = [{ motion: truth, see: motions.seeTruth, colour: ghostColour, ghost: true, way: [] },
          ...methods.map((m) => ({ ...m, see: oddity.between, ghost: false, way: [] }))];
        const fitted = toFit(all(layers[0]), layers.slice(1).flatMap(all));
        stage.fit(fitted);
        [within, reachable] = [box(fitted, 0.02), box(fitted, farthest)];
      },
      /** Paints the time t. The view widens for points that leave the frame, up to `reachable`. */
      paint(t) {
        const seen = layers.map((layer) => seenAt(layer, t)).filter((l) => l);
        stage.widen(seen.map((layer) => layer.drawing).filter((d) => pointsOf(d).some((p) => !within(p)) && pointsOf(d).every(reachable)));
        stage.paint(seen);
      },
      resize() { stage.resize(); },
      /** The viewing direction of a scene in space, in degrees; null for the initial one, and in the plane.
          */
      view: () => stage.seenFrom(),
      look(view) { stage.lookFrom(view); },
    };
  };
})(window.oddity = window.oddity || {});
