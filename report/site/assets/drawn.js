// The recorded motions as they look, for a page that was written without the compiled models: data.scene.drawn
// (report/site/data.cpp) as drawings of the same form as oddity.engine.draw gives.
(function (oddity) {
  'use strict';

  function wholeNumbers(base64) {
    const bytes = atob(base64);
    return Uint16Array.from(
      { length: bytes.length / 2 },
      (_, i) => bytes.charCodeAt(2 * i) | (bytes.charCodeAt(2 * i + 1) << 8),
    );
  }

  /** The points of the things, one after the other, as [x, y, z]. */
  function drawing(drawn, coordinates) {
    const each = drawn.space ? 3 : 2;
    let at = 0;
    const primitives = drawn.things.map(({ kind, size, letter, trail, points }) => ({
      kind,
      size,
      letter,
      trail,
      points: Array.from({ length: points }, () => {
        const [x, y, z = 0] = coordinates.slice(at, (at += each));
        return [x, y, z];
      }),
    }));
    return { space: drawn.space, primitives };
  }

  /** A motion as a function of its frame; after its last it stands. */
  function motion(drawn, base64) {
    const numbers = wholeNumbers(base64),
      each = drawn.moving.length,
      frames = each ? numbers.length / each : 1;
    const at = (frame) => {
      const coordinates = [...drawn.still];
      drawn.moving.forEach((k, i) => {
        coordinates[k] =
          drawn.least +
          ((drawn.most - drawn.least) * numbers[Math.min(frame, frames - 1) * each + i]) / 65535;
      });
      return drawing(drawn, coordinates);
    };
    return { frames, at };
  }

  /** {truth, paths} of data.scene: each {frames, at(frame)}; the truth's first frame is 0, that of a path 1. */
  oddity.drawn = (scene) =>
    scene.drawn && {
      truth: motion(scene.drawn, scene.drawn.truth),
      paths: scene.drawn.paths.map((path) => motion(scene.drawn, path)),
    };
})((window.oddity = window.oddity || {}));
