// The clock of a player: plays, pauses and steps through frames, at three speeds; and its buttons.

(function (oddity) {
  'use strict';

  const speeds = [0.25, 1, 4];
  const shortly = 10;            // s, for a motion whose time is not in seconds
  const patience = 0.1;          // s, the longest that a frame may count
  const { make, icon } = oddity;

  const shapes = {
    play: ['M4 2 L13.5 8 L4 14 Z'],
    pause: ['M3.5 2 H6.8 V14 H3.5 Z M9.2 2 H12.5 V14 H9.2 Z'],
    back: ['M10.5 2.5 L4.5 8 L10.5 13.5 Z', 'M12 2.5 H13.5 V13.5 H12 Z'],
    forward: ['M5.5 2.5 L11.5 8 L5.5 13.5 Z', 'M2.5 2.5 H4 V13.5 H2.5 Z'],
    reset: ['M8 2.2 A5.8 5.8 0 1 1 2.6 6 L4.2 6.6 A4.1 4.1 0 1 0 8 3.9 V6.4 L3.8 3.2 L8 0 Z'],
  };

  const button = (label, click, shape, style) =>
    make('button', { type: 'button', 'aria-label': label, title: label, click, class: style }, icon(...shapes[shape]));

  class Clock {
    constructor({ scene, frame, show }) {
      this.horizon = scene.horizon;
      this.unit = scene.time_unit;
      this.frames = scene.truth.frames;
      this.frame = frame;
      this.show = show;
      this.rate = this.unit === 's' ? 1 : this.horizon / shortly;
      this.time = 0;
      this.speed = 1;
      this.playing = false;
      this.wanted = !oddity.calm();     // plays as soon as it is visible
      this.element = this.build();
    }

    build() {
      this.playButton = button('play', () => this.toggle(), 'play', 'player-play');
      this.scrub = make('input', { type: 'range', class: 'player-scrub', min: 0, max: this.frames, step: 1, value: 0,
        'aria-label': 'time', input: () => this.hold(this.horizon * this.scrub.value / this.frames) });
      this.speedButtons = speeds.map((speed) => make('button', { type: 'button', 'aria-pressed': 'false',
        'aria-label': `speed ${speed}`, click: () => this.setSpeed(speed) }, speed === 0.25 ? '\u00bc' : `${speed}`));
      return make('div', { class: 'player-transport' },
        button('back to the start', () => this.hold(0), 'reset'),
        button('one frame back', () => this.step(-1), 'back'),
        this.playButton,
        button('one frame forward', () => this.step(1), 'forward'),
        this.scrub,
        make('div', { class: 'player-speeds', role: 'group', 'aria-label': 'speed' }, ...this.speedButtons));
    }

    setSpeed(speed) {
      this.speed = speed;
      this.speedButtons.forEach((b, i) => b.setAttribute('aria-pressed', String(speeds[i] === speed)));
    }

    toggle() {
      this.wanted = false;
      if (this.playing) this.pause();
      else this.play();
    }

    /** Plays from the beginning if it has ended. */
    play() {
      if (this.playing) return;
      this.playing = true;
      this.showPlaying();
      if (this.time >= this.horizon) this.seek(0);
      let before = performance.now();
      const frame = (now) => {
        if (!this.playing) return;
        const passed = Math.min(patience, Math.max(0, now - before) / 1000);
        before = now;
        this.seek(this.time + passed * this.speed * this.rate);
        if (this.time >= this.horizon) this.pause();
        else requestAnimationFrame(frame);
      };
      requestAnimationFrame(frame);
    }

    pause() {
      this.playing = false;
      this.showPlaying();
    }

    showPlaying() {
      const name = this.playing ? 'pause' : 'play';
      this.playButton.replaceChildren(icon(...shapes[name]));
      this.playButton.setAttribute('aria-label', name);
      this.playButton.title = name;
    }

    /** Goes to a time and stays there. */
    hold(t) {
      this.wanted = false;
      this.pause();
      this.seek(t);
    }

    step(frames) { this.hold(this.time + frames * this.frame); }

    seek(t) {
      this.time = Math.min(this.horizon, Math.max(0, t));
      this.scrub.value = Math.round(this.time / this.horizon * this.frames);
      this.scrub.setAttribute('aria-valuetext', this.text());
      this.show(this.time);
    }

    text() { return `${this.time.toFixed(2)} ${this.unit}`; }

    /** Pauses while it is out of sight. */
    seen(visible) {
      if (visible && this.wanted) this.play();
      if (visible || !this.playing) return;
      this.pause();
      this.wanted = true;
    }
  }

  oddity.speeds = speeds;
  oddity.clock = (options) => new Clock(options);
})(window.oddity = window.oddity || {});
