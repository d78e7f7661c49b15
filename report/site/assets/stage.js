// oddity.stage: the primitives of chapters/drawing.hpp on a canvas, several motions in layers.
(function (oddity) {
  'use strict';

  const behind = ['sphere', 'track', 'guide', 'axis', 'support'];  // drawn once, in this order
  const things = ['plate', 'disc', 'spring', 'rope', 'rod', 'arrow', 'body'];  // in the plane, from below
  const margin = 26;  // pixels around the drawing
  const plane = { right: [1, 0, 0], up: [0, 1, 0], toward: [0, 0, 1] };

  const opening = { azimuth: Math.PI / 6, elevation: Math.PI / 8 };
  const degrees = (x) => Math.round(1800 * Math.atan2(Math.sin(x), Math.cos(x)) / Math.PI) / 10;

  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const unit = (a) => a.map((x) => x / Math.hypot(...a));
  const between = (least, x, most) => Math.min(most, Math.max(least, x));

  /** Axonometric: z is up; azimuth and elevation are the viewer's. */
  function space(azimuth, elevation) {
    const c = Math.cos(azimuth);
    const s = Math.sin(azimuth);
    const C = Math.cos(elevation);
    const S = Math.sin(elevation);
    return { right: [-s, c, 0], up: [-S * c, -S * s, C], toward: [C * c, C * s, S] };
  }

  const anchorOf = (drawing) => {
    const anchor = drawing.primitives.find((p) => p.kind === 'anchor');
    return anchor ? anchor.points[0] : [0, 0, 0];
  };
  const stands = (p) => behind.includes(p.kind);
  const isShown = (p) => stands(p) || things.includes(p.kind);
  const isRound = (p) => p.kind === 'body' || p.kind === 'disc' || p.kind === 'sphere';

  /** The points that have to fit, relative to the anchor, each with a radius. Fixed parts count once, unless
      the picture moves past them. */
  function cloudOf(drawings) {
    const cloud = [];
    drawings.forEach((drawing, i) => {
      const anchor = anchorOf(drawing);
      const moves = drawing.primitives.some((p) => p.kind === 'anchor');
      for (const p of drawing.primitives) {
        if (!isShown(p) || (stands(p) && i > 0 && !moves)) continue;
        const points = isRound(p) ? p.points.slice(0, 1) : p.points;
        for (const x of points)
          if (x.every(Number.isFinite)) cloud.push([...minus(x, anchor), isRound(p) ? p.size : 0]);
      }
    });
    return cloud;
  }

  class Stage {
    constructor(canvas, options) {
      this.canvas = canvas;
      this.pen = canvas.getContext('2d');
      this.space = Boolean(options.space);
      Object.assign(this, opening);
      this.view = this.space ? space(this.azimuth, this.elevation) : plane;
      this.cloud = this.fitted = [];
      this.layers = [];
      this.anchor = [0, 0, 0];
      this.place = { scale: 1, x: 0, y: 0 };
      canvas.classList.add('stage');
      this.resize();
      this.follow();
      if (this.space) this.obey();
    }

    // ---- interface ----------------------------------------------------------------------------------------

    fit(drawings) {
      this.cloud = this.fitted = cloudOf(drawings);
      this.settle();
    }

    /** As it was fitted, and these drawings besides. */
    widen(drawings) {
      if (!drawings.length && this.cloud === this.fitted) return;
      this.cloud = drawings.length ? [...this.fitted, ...cloudOf(drawings)] : this.fitted;
      this.settle();
    }

    paint(layers) {
      this.layers = layers;
      const { pen, width, height } = this;
      pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
      pen.clearRect(0, 0, width, height);
      pen.lineCap = pen.lineJoin = 'round';
      if (layers.length === 0) return;
      this.anchor = anchorOf(layers[0].drawing);
      this.measureDepth(layers[0].drawing);
      this.background(layers[0].drawing);
      layers.forEach((layer) => this.trails(layer));
      layers.forEach((layer, i) => this.layer(layer, layers.length - 1 - i));
    }

    turn(azimuth, elevation) {
      if (!this.space) return;
      this.azimuth += azimuth;
      this.elevation = between(-Math.PI / 2, this.elevation + elevation, Math.PI / 2);
      this.view = space(this.azimuth, this.elevation);
      this.settle();
      this.paint(this.layers);
    }

    /** {azimuth, elevation} in degrees; null for the initial view. */
    seenFrom() {
      if (!this.space || (this.azimuth === opening.azimuth && this.elevation === opening.elevation)) return null;
      return { azimuth: degrees(this.azimuth), elevation: degrees(this.elevation) };
    }

    /** Sets a view from seenFrom(). */
    lookFrom(view) {
      const radians = (x) => x * Math.PI / 180;
      const { azimuth, elevation } = view ? { azimuth: radians(view.azimuth), elevation: radians(view.elevation) } : opening;
      this.turn(azimuth - this.azimuth, elevation - this.elevation);
      Object.assign(this, { azimuth, elevation });
    }

    /** Adapts to the canvas's present size and the page's colours. */
    resize() {
      const style = getComputedStyle(this.canvas);
      const colour = (name, otherwise) => style.getPropertyValue(name).trim() || otherwise;
      this.ink = colour('--ink', style.color || '#1d1b18');
      this.quiet = colour('--quiet', this.ink);
      this.font = colour('--text-font', 'serif');
      this.ratio = window.devicePixelRatio || 1;
      this.width = this.canvas.clientWidth || this.canvas.width;
      this.height = this.canvas.clientHeight || this.canvas.height;
      this.canvas.width = Math.round(this.width * this.ratio);
      this.canvas.height = Math.round(this.height * this.ratio);
      this.settle();
      this.paint(this.layers);
    }

    // ---- positions ----------------------------------------------------------------------------------------

    /** The scale and centre of the picture. */
    settle() {
      let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
      for (const x of this.cloud) {
        const across = dot(x, this.view.right);
        const up = dot(x, this.view.up);
        left = Math.min(left, across - x[3]);
        right = Math.max(right, across + x[3]);
        low = Math.min(low, up - x[3]);
        high = Math.max(high, up + x[3]);
      }
      if (!(right - left >= 0)) return;
      const edge = Math.min(margin, this.width / 10, this.height / 10);
      const scale = Math.min((this.width - 2 * edge) / (right - left || 1e-9), (this.height - 2 * edge) / (high - low || 1e-9));
      this.place = { scale, x: this.width / 2 - scale * (left + right) / 2, y: this.height / 2 + scale * (low + high) / 2 };
    }

    at(point) {
      const x = minus(point, this.anchor);
      return [this.place.x + this.place.scale * dot(x, this.view.right), this.place.y - this.place.scale * dot(x, this.view.up)];
    }

    /** Whether it can be drawn: false for an exploded motion. */
    inReach(point) { return this.at(point).every((x) => Math.abs(x) < 1e5); }

    near(point) { return dot(minus(point, this.anchor), this.view.toward); }

    measureDepth(drawing) {
      this.nearest = -Infinity;
      this.farthest = Infinity;
      if (!this.space) return;
      for (const p of drawing.primitives)
        for (const x of p.points) {
          const depth = this.near(x);
          this.nearest = Math.max(this.nearest, depth + (p.kind === 'sphere' ? p.size : 0));
          this.farthest = Math.min(this.farthest, depth - (p.kind === 'sphere' ? p.size : 0));
        }
    }

    /** From 0.35, far, to 1, near. */
    presence(depth) {
      if (!(this.nearest > this.farthest)) return 1;
      return 0.35 + 0.65 * between(0, Math.round(4 * (depth - this.farthest) / (this.nearest - this.farthest)) / 4, 1);
    }

    // ---- strokes ------------------------------------------------------------------------------------------

    line(spots, width) {
      this.pen.beginPath();
      spots.forEach(([x, y], i) => (i ? this.pen.lineTo(x, y) : this.pen.moveTo(x, y)));
      this.pen.lineWidth = width;
      this.pen.stroke();
    }

    area(spots, opacity) {
      const { pen } = this;
      const whole = pen.globalAlpha;
      pen.beginPath();
      spots.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
      pen.closePath();
      pen.globalAlpha = whole * opacity;
      pen.fill();
      pen.globalAlpha = whole;
    }

    ball([x, y], radius) {
      this.pen.beginPath();
      this.pen.arc(x, y, radius, 0, 2 * Math.PI);
    }

    /** A line whose far parts are paler. */
    deepLine(points, width, opacity) {
      const { pen } = this;
      let run = [];
      let now = 1;
      const end = () => {
        pen.globalAlpha = now * opacity;
        if (run.length > 1) this.line(run, width);
      };
      for (let i = 0; i + 1 < points.length; i += 1) {
        const next = this.presence((this.near(points[i]) + this.near(points[i + 1])) / 2);
        run.push(this.at(points[i]));
        if (next !== now) {
          end();
          run = [this.at(points[i])];
          now = next;
        }
      }
      run.push(this.at(points[points.length - 1]));
      end();
      pen.globalAlpha = 1;
    }

    shaft(from, to, width) {
      const [x, y] = [to[0] - from[0], to[1] - from[1]];
      const size = Math.min(9, 0.6 * Math.hypot(x, y));
      if (!(size > 0)) return;
      const along = [x / Math.hypot(x, y), y / Math.hypot(x, y)];
      const back = [to[0] - size * along[0], to[1] - size * along[1]];
      const aside = [0.38 * size * along[1], -0.38 * size * along[0]];
      const dashes = this.pen.getLineDash();
      this.line([from, [to[0] - 0.8 * size * along[0], to[1] - 0.8 * size * along[1]]], width);
      this.pen.setLineDash([]);
      this.area([to, [back[0] + aside[0], back[1] + aside[1]], [back[0] - aside[0], back[1] - aside[1]]], 1);
      this.pen.setLineDash(dashes);
    }

    // ---- fixed parts --------------------------------------------------------------------------------------

    background(drawing) {
      const { pen } = this;
      pen.strokeStyle = pen.fillStyle = this.ink;
      for (const kind of behind)
        for (const p of drawing.primitives)
          if (p.kind === kind) this[kind](p);
      pen.globalAlpha = 1;
    }

    sphere(p) {
      this.ball(this.at(p.points[0]), p.size * this.place.scale);
      this.pen.globalAlpha = 0.05;
      this.pen.fill();
      this.pen.globalAlpha = 0.35;
      this.pen.lineWidth = 1;
      this.pen.stroke();
    }

    track(p) { this.deepLine(p.points, 1.3, 0.7); }

    guide(p) {
      this.pen.setLineDash([4, 4]);
      this.deepLine(p.points, 1, 0.5);
      this.pen.setLineDash([]);
    }

    axis(p) {
      const [from, to] = p.points.map((x) => this.at(x));
      const { pen } = this;
      pen.globalAlpha = 0.7;
      this.shaft(from, to, 1);
      const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
      this.letter(p.letter, [to[0] + 12 * (to[0] - from[0]) / length, to[1] + 12 * (to[1] - from[1]) / length]);
    }

    letter(text, [x, y]) {
      if (!text) return;
      const { pen } = this;
      const [, base, index] = /^(\D*?)(\d*)$/.exec(text) || [null, text, ''];
      pen.font = `italic 16px ${this.font}`;
      pen.textAlign = 'center';
      pen.textBaseline = 'middle';
      pen.fillText(base, x, y);
      const after = x + pen.measureText(base).width / 2;
      pen.font = `11px ${this.font}`;
      pen.textAlign = 'left';
      pen.fillText(index, after, y + 5);
    }

    support(p) {
      const { pen } = this;
      pen.globalAlpha = 1;
      if (p.points.length === 1) {
        this.ball(this.at(p.points[0]), 3.5);
        pen.fill();
        return;
      }
      const [from, to] = p.points.map((x) => this.at(x));
      const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
      const along = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
      this.line([from, to], 1.8);
      pen.globalAlpha = 0.6;
      for (let s = 8; s <= length; s += 8) {
        const x = [from[0] + s * along[0], from[1] + s * along[1]];
        this.line([x, [x[0] - 7 * along[1] - 6 * along[0], x[1] + 7 * along[0] - 6 * along[1]]], 1);
      }
    }

    // ---- moving parts -------------------------------------------------------------------------------------

    trails(layer) {
      const { pen } = this;
      const ways = layer.trails || (layer.trail && layer.trail.length ? [layer.trail] : []);
      pen.strokeStyle = layer.colour;
      for (const way of ways) this.trail(way, layer.ghost);
      pen.globalAlpha = 1;
    }

    /** Older parts are paler. */
    trail(way, ghost) {
      const spots = way.filter((x) => this.inReach(x)).map((x) => this.at(x));
      const parts = Math.min(12, spots.length - 1);
      for (let k = 0; k < parts; k += 1) {
        const from = Math.floor(k * (spots.length - 1) / parts);
        const to = Math.floor((k + 1) * (spots.length - 1) / parts);
        this.pen.globalAlpha = (ghost ? 0.45 : 0.75) * (0.12 + 0.88 * ((k + 1) / parts) ** 2);
        this.line(spots.slice(from, to + 1), 1.6);
      }
    }

    /** Broader than the layers above it, so that it stays visible where they agree. */
    layer({ drawing, colour, ghost }, above) {
      const { pen } = this;
      this.broader = ghost ? 0 : 1.5 * above;
      pen.strokeStyle = pen.fillStyle = colour;
      this.full = ghost ? 0.6 : 1;
      pen.setLineDash(ghost ? [6, 4] : []);
      const parts = drawing.primitives.filter((p) => things.includes(p.kind)).flatMap((p) => this.parts(p));
      parts.sort((a, b) => a.order - b.order);
      for (const part of parts) {
        pen.globalAlpha = this.full;
        this[part.kind](part, ghost);
      }
      pen.setLineDash([]);
      pen.globalAlpha = 1;
    }

    /** In space a rod may be partly in front of a thing and partly behind it. */
    parts(p) {
      if (!p.points.every((x) => this.inReach(x))) return [];
      if (!this.space) return [{ ...p, order: things.indexOf(p.kind) }];
      const depth = (points) => points.reduce((sum, x) => sum + this.near(x), 0) / points.length;
      if (p.kind !== 'rod') return [{ ...p, order: depth(isRound(p) ? p.points.slice(0, 1) : p.points) }];
      const [from, to] = p.points;
      const n = this.pen.getLineDash().length ? 2 : 10;
      const at = (u) => from.map((x, k) => x + u * (to[k] - x));
      return Array.from({ length: n }, (_, i) => [at(i / n), at((i + 1) / n)])
        .map((points) => ({ ...p, points, order: depth(points) }));
    }

    rod(p) { this.line(p.points.map((x) => this.at(x)), 2.5 + this.broader); }

    rope(p) { this.line(p.points.map((x) => this.at(x)), 1.5 + this.broader / 2); }

    spring(p) {
      const [from, to] = p.points.map((x) => this.at(x));
      const way = [to[0] - from[0], to[1] - from[1]];
      const length = Math.hypot(...way) || 1;
      const width = between(3, 0.5 * p.size * this.place.scale, 10) / length;
      const spot = (along, aside) => [from[0] + along * way[0] + aside * way[1], from[1] + along * way[1] - aside * way[0]];
      const line = [from, spot(0.12, 0)];
      for (let i = 0; i < 18; i += 1) line.push(spot(0.12 + 0.76 * (i + 0.5) / 18, i % 2 ? -width : width));
      line.push(spot(0.88, 0), to);
      const dashes = this.pen.getLineDash();
      this.pen.setLineDash([]);
      this.line(line, 1.4);
      this.pen.setLineDash(dashes);
    }

    disc(p) {
      const rim = this.space ? this.rim(p) : null;
      if (rim) {
        this.area(rim, 0.16);
        this.line([...rim, rim[0]], 1.5);
        return;
      }
      const { pen } = this;
      this.ball(this.at(p.points[0]), p.size * this.place.scale);
      pen.globalAlpha = 0.16 * this.full;
      pen.fill();
      pen.globalAlpha = this.full;
      pen.lineWidth = 1.5;
      pen.stroke();
    }

    rim(p) {
      const normal = unit(minus(p.points[1], p.points[0]));
      const u = unit(cross(normal, Math.abs(normal[2]) > 0.9 ? [1, 0, 0] : [0, 0, 1]));
      const v = cross(normal, u);
      return Array.from({ length: 40 }, (_, i) => {
        const [c, s] = [Math.cos(Math.PI * i / 20), Math.sin(Math.PI * i / 20)];
        return this.at(p.points[0].map((x, k) => x + p.size * (c * u[k] + s * v[k])));
      });
    }

    plate(p) {
      const spots = p.points.map((x) => this.at(x));
      this.area(spots, 0.25);
      this.line([...spots, spots[0]], 2);
    }

    arrow(p) { this.shaft(...p.points.map((x) => this.at(x)), 2.2); }

    /** A ghost is a ring. */
    body(p, ghost) {
      const { pen } = this;
      this.ball(this.at(p.points[0]), Math.max(ghost ? 3.5 : 3, p.size * this.place.scale) + this.broader);
      pen.globalAlpha = ghost ? 0.25 : 0.9;
      pen.fill();
      pen.globalAlpha = this.full;
      if (!ghost) return;
      pen.lineWidth = 1.5;
      pen.setLineDash([3, 2]);
      pen.stroke();
      pen.setLineDash([6, 4]);
    }

    // ---- events of the canvas -----------------------------------------------------------------------------

    follow() {
      new ResizeObserver(() => {
        if (this.canvas.clientWidth !== this.width || this.canvas.clientHeight !== this.height) this.resize();
      }).observe(this.canvas);
      matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.resize());
    }

    /** Turned by dragging, and by the arrow keys if it has the focus. */
    obey() {
      const { canvas } = this;
      canvas.classList.add('stage-turns');
      if (!canvas.hasAttribute('tabindex')) canvas.tabIndex = 0;
      let held = null;
      canvas.addEventListener('pointerdown', (event) => {
        if (event.button !== 0) return;
        held = { x: event.clientX, y: event.clientY };
        canvas.setPointerCapture(event.pointerId);
      });
      canvas.addEventListener('pointermove', (event) => {
        if (!held) return;
        this.turn((held.x - event.clientX) * 0.01, (event.clientY - held.y) * 0.01);
        held = { x: event.clientX, y: event.clientY };
      });
      const release = () => { held = null; };
      canvas.addEventListener('pointerup', release);
      canvas.addEventListener('pointercancel', release);
      canvas.addEventListener('keydown', (event) => {
        const by = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
        if (!by || event.shiftKey || event.ctrlKey || event.altKey || event.metaKey) return;
        event.preventDefault();
        event.stopPropagation();
        this.turn(...by);
      });
    }
  }

  oddity.stage = (canvas, options = {}) => new Stage(canvas, options);
})(window.oddity = window.oddity || {});
