// The page for typing a problem's file: its errors, its motions, the cheapest method that is enough, and the
// code.

(function (oddity) {
  'use strict';

  const { make } = oddity;
  const patience = 40;        // ms after a key
  const slice = 12;           // ms of search for a method, at a time
  const mostOfAFile = 1000000;  // bytes, as in problem/file.hpp

  /** A player whose link contains the file. */
  class OwnPlayer extends oddity.Player {
    constructor(element, motions, begin, typing) {
      super(element, motions, begin);
      this.typing = typing;
    }
    fromLink() { return null; }
    goTo() {}                 // the page reads the address
    async link() {
      const hash = await oddity.fileLink.format(this.typing.text, oddity.permalink.format(this.state()));
      if (!hash) {
        this.typing.says.textContent = 'The file is too long for a link: send it as a file.';
        return;
      }
      this.typing.linked = hash;
      window.location.hash = hash;
      this.copy(window.location.href, 'Copied');
    }
    compute() {
      super.compute();
      if (this.typing) this.typing.look();
    }
  }

  class Typing {
    constructor(place) {
      this.place = place;
      place.oddity = this;
      this.text = '';
      this.turn = 0;          // number of the present text: answers for an earlier one are not shown
      this.build();
      window.addEventListener('hashchange', () => this.fromAddress());
    }

    build() {
      this.area = make('textarea', { id: 'own-file', class: 'own-file', spellcheck: 'false', autocomplete: 'off', wrap: 'off',
        'aria-describedby': 'own-wrong', input: () => this.later(), scroll: () => this.mark() });
      this.menu = make('select', { id: 'own-example', change: () => this.example() });
      this.line = make('div', { class: 'own-line', hidden: true, 'aria-hidden': 'true' });
      this.wrong = make('pre', { id: 'own-wrong', class: 'own-wrong', role: 'status', 'aria-live': 'polite', tabindex: '0', hidden: true });
      this.says = make('p', { class: 'own-says', role: 'status', 'aria-live': 'polite' });
      this.asks = make('p', { class: 'own-asks' });
      this.answer = make('p', { class: 'own-answer', 'aria-live': 'polite' });
      this.alone = make('p', { class: 'own-alone', hidden: true }, 'Judged for this start alone, by the page\u2019s own truth. ',
        make('code', {}, `${oddity.program} choose FILE`), ' tries others, by true motions in more digits.');
      this.figure = make('section', { class: 'player', 'aria-label': 'Player' });
      this.code = make('pre', { class: 'code own-code', tabindex: '0' });
      this.codeOf = make('select', { id: 'own-code-of', change: () => this.showCode() });
      this.copied = make('button', { type: 'button', click: () => this.copyCode() }, 'Copy');
      this.claims = make('section', { class: 'own-claims', hidden: true, 'aria-live': 'polite' });
      this.file = make('input', { id: 'own-open', type: 'file', accept: '.toml,.csv,.txt', change: () => this.open(this.file.files) });
      this.coding = make('details', { class: 'own-coding', hidden: true }, make('summary', {}, 'Its program in C++'),
        make('p', {}, make('label', { for: 'own-code-of' }, 'Model '), this.codeOf, ' ', this.copied), this.code);
      this.place.replaceChildren(
        make('div', { class: 'own-typed' },
          make('p', {}, make('label', { for: 'own-example' }, 'Begin with '), this.menu, ' ',
            make('label', { for: 'own-open' }, 'or open a file, or a table of numbers (CSV): '), this.file),
          make('label', { for: 'own-file', class: 'own-name' }, 'The file'),
          make('div', { class: 'own-paper' }, this.line, this.area), this.wrong, this.says),
        make('div', { class: 'own-shown' }, this.asks, this.answer, this.alone, this.figure, this.claims, this.coding));
      this.place.addEventListener('dragover', (event) => event.preventDefault());
      this.place.addEventListener('drop', (event) => {
        event.preventDefault();
        this.open(event.dataTransfer.files);
      });
    }

    // ---- the text -----------------------------------------------------------------------------------------

    offer(examples) {
      this.examples = examples;
      this.menu.replaceChildren(...examples.map(({ title }, i) => make('option', { value: i }, title)));
    }

    example() {
      this.set(this.examples[this.menu.value].text);
    }

    set(text, play = '') {
      this.area.value = text;
      this.area.scrollTop = 0;
      this.keeps = false;
      return this.read(play);
    }

    /** A problem's file takes the place of the text; a table of numbers comes behind it. */
    async open([file]) {
      if (!file) return;
      if (file.size > mostOfAFile) {
        this.says.textContent = `${file.name} is longer than the megabyte that the page takes.`;
        return;
      }
      const text = await file.text();
      this.file.value = '';
      if (file.name.endsWith('.toml')) return this.set(text);
      const name = oddity.nameOfTable(file.name, this.area.value);
      await this.set(oddity.withTable(this.area.value, name, text));
      this.says.textContent = `The table ${name} is at the end of the file: say its units there, and call it as ${name}(t).`;
    }

    later() {
      clearTimeout(this.waiting);
      this.waiting = setTimeout(() => this.read(), patience);
    }

    async fromAddress() {
      if (window.location.hash === this.linked) return false;
      const read = await oddity.fileLink.parse(window.location.hash);
      if (!read) return false;
      if (read.problem) {
        this.says.textContent = `${read.problem} This is the page as it opens.`;
        return false;
      }
      await this.set(read.text, read.play);
      return true;
    }

    async read(play = '') {
      clearTimeout(this.waiting);
      const turn = this.turn += 1;
      const began = performance.now();
      const text = this.area.value;
      this.says.textContent = '';
      this.menu.selectedIndex = this.examples.findIndex((one) => one.text === text);
      const result = await oddity.engine.take(text);
      if (turn !== this.turn) return;
      if (result.wrong) this.refuse(result.wrong);
      else this.show(text, result.file, play);
      this.place.dataset.took = (performance.now() - began).toFixed(1);
      this.place.dataset.read = String(turn);
    }

    /** The display belongs to another text. */
    refuse({ line, message }) {
      this.wrong.textContent = message;
      this.wrong.hidden = false;
      this.area.setAttribute('aria-invalid', 'true');
      this.wrongLine = line;
      this.mark();
      this.figure.classList.add('stale');
      this.stop();
      this.answer.textContent = '';
      this.alone.hidden = true;
      this.claims.hidden = true;
      this.coding.hidden = true;
    }

    mark() {
      this.line.hidden = !this.wrongLine;
      if (!this.wrongLine) return;
      const style = getComputedStyle(this.area);
      const top = parseFloat(style.paddingTop) + (this.wrongLine - 1) * parseFloat(style.lineHeight) - this.area.scrollTop;
      this.line.style.transform = `translateY(${top}px)`;
      this.line.hidden = top < 0 || top > this.area.clientHeight;
    }

    // ---- results ------------------------------------------------------------------------------------------

    show(text, file, play) {
      this.text = text;
      this.wrongLine = 0;
      this.mark();
      this.wrong.hidden = true;
      this.area.removeAttribute('aria-invalid');
      this.figure.classList.remove('stale');
      this.asks.textContent = file.question;
      this.stop();
      const moves = oddity.engine.scene('own') !== null;
      this.figure.hidden = this.coding.hidden = !moves;
      this.judge(file.claims, moves);
      if (!moves) {
        this.drop();
        this.alone.hidden = true;
        this.answer.textContent = '';
        return;
      }
      this.play(oddity.problem(file, oddity.engine), play);
      const models = oddity.engine.scene('own').models.map((m) => m.name);
      this.codeOf.replaceChildren(...models.map((name) => make('option', { value: name }, name)));
      this.codeOf.value = models[models.length - 1];
      this.showCode();
    }

    judge(count, moves) {
      const { turn } = this;
      this.claims.hidden = count === 0;
      if (count === 0) return;
      oddity.showClaims(this.claims, count, () => turn === this.turn, () => {
        if (!moves) this.place.dataset.answered = 'yes';
      });
    }

    drop() {
      if (this.player) this.player.end();
      this.player = null;
      this.figure.replaceChildren();
    }

    /** Takes the state from a link; otherwise keeps the methods and the time as far as the file still has
        them. */
    begin(motions, link) {
      const usual = { parameters: {}, rows: motions.opening(), time: 0, speed: 1 };
      const missing = 'the file does not have';
      const read = link ? oddity.permalink.parse(link, { ...oddity.nameable(motions, motions.data.parameters), missing }) : null;
      if (read && read.problem) this.says.textContent = `${read.problem} The rest is as in the link.`;
      const before = this.player && this.keeps ? { ...this.player.state(), parameters: {} } : usual;
      const state = read && read.state ? read.state : before;
      const rows = state.rows.filter((row) => motions.find(row.model, row.algorithm));
      return { ...state, rows: rows.length ? rows : usual.rows, view: null };
    }

    play(motions, link) {
      const begin = this.begin(motions, link);
      const moves = this.player && this.keeps && this.player.clock.playing;
      this.drop();
      this.keeps = true;
      this.player = new OwnPlayer(this.figure, motions, begin, this);
      this.look();
      if (moves) this.player.clock.play();
    }

    /** By the cheapest method that is enough and has a loop to print; without one, by a step a frame. */
    showCode() {
      const { motions, parameters } = this.player;
      const model = this.codeOf.value;
      const found = this.programs && this.programs.get(model);
      const { algorithm } = motions.algorithmsOf(model)[0];
      const plain = oddity.isPrintable(algorithm) ? algorithm : 'Runge-Kutta 4';
      const { method, says } = found || { method: { model, algorithm: plain, setting: motions.frame },
        says: `${plain} on ${model}, which may not be enough.` };
      const text = oddity.wholeProgram(motions, parameters, method, says);
      this.code.textContent = text || 'This model has no code to print: it has events, or letters that C++ has another meaning for.';
      this.copied.disabled = !text;
    }

    async copyCode() {
      try {
        await navigator.clipboard.writeText(this.code.textContent);
        this.copied.textContent = 'Copied';
      } catch (error) {
        getSelection().selectAllChildren(this.code);
        this.copied.textContent = 'Selected';
      }
    }

    // ---- the search for a method --------------------------------------------------------------------------

    stop() {
      clearTimeout(this.looking);
      delete this.place.dataset.answered;
    }

    /** In pieces, between which the page can respond. */
    look() {
      const { player } = this;
      if (!player || this.figure.classList.contains('stale')) return;
      const { motions, parameters } = player;
      const key = JSON.stringify(parameters);
      if (this.lookedFor && this.lookedFor.motions === motions && this.lookedFor.key === key) return;
      this.lookedFor = { motions, key };
      this.programs = null;
      this.stop();
      this.answer.textContent = 'Which method is enough is being looked for.';
      this.alone.hidden = true;
      const pieces = oddity.enough(motions, parameters);
      const next = () => {
        const end = performance.now() + slice;
        let last = pieces.next();
        while (!last.value.done && performance.now() < end) last = pieces.next();
        this.answer.textContent = last.value.text;
        this.alone.hidden = !last.value.best;
        player.showTruth();
        if (!last.value.done) {
          this.looking = setTimeout(next, 0);
          return;
        }
        this.place.dataset.answered = 'yes';
        this.programs = last.value.programs;
        this.showCode();
      };
      this.looking = setTimeout(next, slice);
    }
  }

  async function start(place) {
    if (!(await oddity.engine.ready)) {
      place.textContent = 'This browser cannot run the page\u2019s reader of files: it has no exceptions in WebAssembly.';
      return;
    }
    const typing = new Typing(place);
    typing.offer(oddity.allExamples);
    if (!(await typing.fromAddress())) {
      const { textContent } = typing.says;
      await typing.set(oddity.allExamples[0].text);
      typing.says.textContent = textContent;
    }
    place.dataset.ready = 'yes';
  }

  /** Called by data/problems.js. */
  oddity.problems = async function (packed) {
    const { files, programs, taken } = await oddity.unpacked(packed);
    oddity.allExamples = files;
    oddity.programs = programs;
    oddity.takenNames = taken;
    document.querySelectorAll('.own').forEach((place) => { start(place); });
  };
})(window.oddity = window.oddity || {});
