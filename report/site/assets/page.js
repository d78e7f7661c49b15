// Shared by all pages: the exercise's data, filters, links into folded sections, buttons that play a trial,
// and the moving pictures.
(function (oddity) {
  'use strict';

  const waiting = [];

  function whole_method({ models, algorithms, resolutions }, [model, algorithm, resolution, in_float, trials]) {
    return {
      model: models[model],
      algorithm: algorithms[algorithm],
      resolution: resolutions[resolution].name,
      precision: in_float ? 'float' : 'double',
      trials: trials.map((trial, i) => [resolutions[resolution].settings[i], ...trial]),
    };
  }

  // Unpacks the data in data/*.js: base64 of gzip.
  oddity.unpacked = async (packed) => {
    const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
    return JSON.parse(await new Response(stream).text());
  };

  if (!window.DecompressionStream)
    document.querySelector('main').prepend(Object.assign(document.createElement('p'), { className: 'failure',
      textContent: 'This browser is too old for players and charts: it has no DecompressionStream.' }));

  // Called by data/3.5.js.
  oddity.exercise = async (packed) => {
    const data = await oddity.unpacked(packed);
    for (const quantity of data.quantities)
      quantity.methods = quantity.methods.map((method) => whole_method(quantity, method));
    oddity.data = data;
    waiting.splice(0).forEach((act) => act(data));
    document.dispatchEvent(new CustomEvent('oddity:data', { detail: data }));
  };

  // Acts once the exercise's data are loaded.
  oddity.with_data = (act) => {
    if (oddity.data) act(oddity.data);
    else waiting.push(act);
  };

  oddity.element = (name, attributes, ...children) => {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes || {})) {
      if (value === true) made.setAttribute(key, '');
      else if (value !== false && value !== undefined && value !== null) made.setAttribute(key, value);
    }
    made.append(...children);
    return made;
  };

  oddity.calm = () => matchMedia('(prefers-reduced-motion: reduce)').matches;

  // ---- links into folded sections

  function open_target() {
    let target = null;
    try {
      target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    } catch (error) {
      return;  // an invalid hash
    }
    if (!target) return;
    for (let at = target; at; at = at.parentElement) if (at.tagName === 'DETAILS') at.open = true;
    target.hidden = false;
    target.scrollIntoView();
  }

  // Folded sections are printed as well.
  function open_for_print() {
    document.querySelectorAll('#findings details:not([open])').forEach((details) => {
      details.open = true;
      addEventListener('afterprint', () => { details.open = false; }, { once: true });
    });
  }

  // ---- the findings' filter

  function kind_of(article) {
    const kind = article.querySelector('.meta .kind');
    return kind ? kind.textContent : '';
  }

  function choices_of(articles) {
    const counts = new Map();
    const add = (name, test) => {
      const chosen = articles.filter(test);
      if (chosen.length > 0 && chosen.length < articles.length) counts.set(name, chosen);
    };
    for (const verdict of ['wrong', 'incomplete', 'misprint'])
      add(verdict, (article) => article.classList.contains(verdict));
    new Set(articles.map(kind_of)).forEach((kind) => { if (kind) add(kind, (article) => kind_of(article) === kind); });
    return counts;
  }

  function build_filter(place) {
    const section = place.parentElement;
    const articles = [...section.querySelectorAll('article')];
    const choices = choices_of(articles);
    if (choices.size === 0) return;
    const claims = document.getElementById('claims');
    const show = (chosen, button) => {
      articles.forEach((article) => { article.hidden = !chosen.includes(article); });
      section.querySelectorAll('.root').forEach((root) => { root.hidden = !root.querySelector('article:not([hidden])'); });
      if (claims) claims.hidden = button !== all;
      place.querySelectorAll('button').forEach((other) => other.setAttribute('aria-pressed', String(other === button)));
    };
    const add = (name, chosen) => {
      const button = oddity.element('button', { type: 'button', 'aria-pressed': 'false' }, `${name} `,
        oddity.element('small', {}, String(chosen.length)));
      button.addEventListener('click', () => show(chosen, button));
      place.append(button);
      return button;
    };
    place.setAttribute('role', 'group');
    place.setAttribute('aria-label', 'Which findings are shown');
    const confirmed = claims ? claims.querySelectorAll('.claims > details').length : 0;
    const all = add('all claims', articles);
    all.lastChild.textContent = String(articles.length + confirmed);
    add('findings', articles);
    choices.forEach((chosen, name) => add(name, chosen));
    all.setAttribute('aria-pressed', 'true');
  }

  // ---- scrollable parts are reachable by keyboard

  function let_scroll() {
    document.querySelectorAll('.sides dd, main p, main li').forEach((side) => {
      if (side.scrollWidth > side.clientWidth) side.tabIndex = 0;
      else side.removeAttribute('tabindex');
    });
  }

  // ---- buttons that play a trial

  function build_play_buttons(data) {
    document.querySelectorAll('button[data-play]').forEach((button) => {
      const [place, setting] = button.dataset.play.split(' ').map(Number);
      const name = button.closest('.quantity').querySelector('.chart').dataset.quantity;
      const quantity = data.quantities.find((q) => q.name === name);
      const method = quantity && quantity.methods[place];
      if (!method || !data.scene || !document.querySelector('.player')) return;
      button.hidden = false;
      button.setAttribute('aria-label', `play ${method.model}, ${method.algorithm}`);
      button.addEventListener('click', () => document.dispatchEvent(new CustomEvent('oddity:play', {
        detail: { model: method.model, algorithm: method.algorithm, precision: method.precision, setting },
      })));
    });
  }

  // ---- code to copy

  function build_copy_buttons() {
    document.querySelectorAll('pre.code').forEach((code) => {
      const button = oddity.element('button', { type: 'button' }, 'Copy');
      const place = oddity.element('div', { class: 'copied' });
      code.replaceWith(place);
      place.append(code, button);
      button.addEventListener('click', async () => {
        try {
          await navigator.clipboard.writeText(code.textContent);
          button.textContent = 'Copied';
        } catch (error) {
          getSelection().selectAllChildren(code);
          button.textContent = 'Selected';
        }
      });
    });
  }

  // ---- the moving pictures

  function build_pictures() {
    const pictures = [...document.querySelectorAll('.thumb svg')];
    const button = document.querySelector('.stop button');
    if (pictures.length === 0 || !button) return;
    let moving = !oddity.calm();
    const in_view = new Set();
    const begin = (svg) => {
      if (svg.dataset.begun) return;
      svg.dataset.begun = 'yes';
      svg.querySelectorAll('animate').forEach((animation) => animation.beginElement());
    };
    const set = (svg) => {
      if (moving && in_view.has(svg)) {
        begin(svg);
        svg.unpauseAnimations();
      } else {
        svg.pauseAnimations();
      }
    };
    const watcher = new IntersectionObserver((entries) => entries.forEach((entry) => {
      if (entry.isIntersecting) in_view.add(entry.target);
      else in_view.delete(entry.target);
      set(entry.target);
    }));
    pictures.forEach((svg) => watcher.observe(svg));
    const name = () => { button.textContent = moving ? 'Stop the pictures' : 'Let the pictures move'; };
    button.addEventListener('click', () => {
      moving = !moving;
      name();
      pictures.forEach(set);
    });
    name();
    button.hidden = false;
  }

  document.querySelectorAll('.filter').forEach(build_filter);
  oddity.with_data(build_play_buttons);
  build_pictures();
  build_copy_buttons();
  open_target();
  let_scroll();
  addEventListener('resize', let_scroll);
  addEventListener('hashchange', open_target);
  addEventListener('beforeprint', open_for_print);
})(window.oddity = window.oddity || {});
