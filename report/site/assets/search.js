// Search over exercises, claims, quantities, methods and pages, allowing one misspelling per word. The index,
// data/search.js, is loaded at the first search.
(function (oddity) {
  'use strict';

  const most = 40;
  const least_to_misspell = 4;   // letters
  let entries = null, vocabulary = null, dialog = null;
  const finders = [];

  // Called by data/search.js.
  oddity.index = async (packed) => {
    const all = await oddity.unpacked(packed);
    const names = new Map(all.filter(([, kind]) => kind === 'exercise').map(([to, , title]) => [to, title]));
    entries = all.map(([to, kind, named, text]) => {
      const [page, place] = to.split('#');
      const title = named || place;
      return { to, page, kind, title, text, words: `${title} ${text} ${kind} ${names.get(page) || ''}`.toLowerCase() };
    });
    vocabulary = [...new Set(entries.flatMap((entry) => entry.words.split(/[^\p{L}]+/u)))]
      .filter((word) => word.length >= least_to_misspell);
    finders.forEach((finder) => finder.show());
  };

  function load_index() {
    if (entries || document.querySelector('script[src="data/search.js"]')) return;
    const script = document.createElement('script');
    script.src = 'data/search.js';
    script.onerror = () => finders.forEach((finder) => finder.say('The index, data/search.js, is not there.'));
    document.body.append(script);
  }

  // ---- the search

  // One letter inserted, deleted or replaced, or two neighbours exchanged.
  function is_slip(a, b) {
    if (Math.abs(a.length - b.length) > 1) return false;
    let from = 0;
    while (from < a.length && a[from] === b[from]) from += 1;
    const rest_a = a.slice(from), rest_b = b.slice(from);
    return rest_a.slice(1) === rest_b.slice(1) || rest_a.slice(1) === rest_b || rest_a === rest_b.slice(1)
      || (rest_a[0] === rest_b[1] && rest_a[1] === rest_b[0] && rest_a.slice(2) === rest_b.slice(2));
  }

  // The word, or if it is unknown, similar words and beginnings of words.
  function meant_by(word) {
    if (word.length < least_to_misspell || entries.some((entry) => entry.words.includes(word))) return [word];
    const whole = vocabulary.filter((known) => is_slip(word, known));
    const begun = [-1, 0, 1].map((more) => word.length + more);
    return whole.length ? whole
      : [...new Set(vocabulary.flatMap((known) => begun.map((n) => known.slice(0, n))))].filter((known) => is_slip(word, known));
  }

  // Every word must occur in an entry. Matches in titles and wrong claims come first.
  function found(query, fits) {
    const words = query.toLowerCase().split(/[\s\u2010-\u2015-]+/).filter(Boolean).map(meant_by);
    const ranks = { page: 5, exercise: 4, method: 4, wrong: 3, incomplete: 2, misprint: 2, quantity: 1 };
    const weight = (entry) => {
      const title = entry.title.toLowerCase();
      const of = (word) => (title.startsWith(word) ? 12 : title.includes(word) ? 6 : 0);
      return words.reduce((sum, some) => sum + Math.max(...some.map(of)), 0) + (ranks[entry.kind] || 0);
    };
    const hits = entries.filter((entry) => fits(entry) && words.every((some) => some.some((word) => entry.words.includes(word))))
      .map((entry) => [weight(entry), entry]).sort((a, b) => b[0] - a[0]).map(([, entry]) => entry);
    const corrected = words.filter((some) => some.length && !query.toLowerCase().includes(some[0])).map((some) => some.join(' or '));
    return { hits, corrected };
  }

  const brief = (text) => (text.length > 140 ? text.slice(0, text.lastIndexOf(' ', 137)) + '...' : text);

  // ---- a field and its list

  /** Shows entries for the text in `input` as options of `list`; arrow keys move through them, and Enter
      opens one. `fits` selects entries, `say` shows a sentence, `opened` is called when one is opened. */
  oddity.finder = ({ input, list, say, idle = '', fits = () => true, limit = most, opened = () => {} }) => {
    let chosen = -1;
    let waits = false;   // Enter was pressed before the index was loaded

    function item_of(entry, place) {
      const item = oddity.element('li', { role: 'option', id: `${list.id}-${place}`, 'aria-selected': 'false' },
        oddity.element('a', { href: entry.to, tabindex: '-1' },
          oddity.element('b', { class: `kind ${entry.kind.replace(/\W/g, '-')}` }, entry.kind), ' ',
          oddity.element('span', {}, entry.title),
          oddity.element('small', {}, brief(entry.text))));
      item.addEventListener('click', opened);
      return item;
    }

    function choose(place) {
      const items = list.children;
      if (items[chosen]) items[chosen].setAttribute('aria-selected', 'false');
      chosen = Math.max(-1, Math.min(place, items.length - 1));
      if (chosen < 0) return input.removeAttribute('aria-activedescendant');
      items[chosen].setAttribute('aria-selected', 'true');
      items[chosen].scrollIntoView({ block: 'nearest' });
      input.setAttribute('aria-activedescendant', items[chosen].id);
    }

    function sentence(query, hits, corrected) {
      if (!query) return idle;
      if (!hits.length) return 'Nothing has all these words.';
      const count = hits.length > limit ? `${hits.length} found, the first ${limit} shown` : `${hits.length} found`;
      return corrected.length ? `${count}, for ${corrected.join(', ')}` : count;
    }

    function show() {
      if (!entries) return load_index();
      const query = input.value.trim();
      const { hits, corrected } = query ? found(query, fits) : { hits: [], corrected: [] };
      list.replaceChildren(...hits.slice(0, limit).map(item_of));
      choose(hits.length > 0 ? 0 : -1);
      say(sentence(query, hits, corrected));
      if (waits) follow();
    }

    function follow() {
      waits = !entries;
      if (list.children[chosen]) list.children[chosen].querySelector('a').click();
    }

    input.addEventListener('input', show);
    input.addEventListener('keydown', (event) => {
      const moves = { ArrowDown: 1, ArrowUp: -1 };
      if (event.key in moves) {
        event.preventDefault();
        choose(Math.max(0, chosen + moves[event.key]));
      } else if (event.key === 'Enter') {
        follow();
      }
    });
    const finder = { show, say, follow };
    finders.push(finder);
    return finder;
  };

  /** A search field and its list. */
  oddity.searched = (id, label, placeholder) => ({
    input: oddity.element('input', { type: 'search', 'aria-label': label, placeholder, role: 'combobox', 'aria-expanded': 'true',
      'aria-controls': id, 'aria-autocomplete': 'list', autocomplete: 'off', spellcheck: 'false' }),
    list: oddity.element('ul', { id, role: 'listbox', 'aria-label': 'What was found' }),
    said: oddity.element('p', { class: 'said', 'aria-live': 'polite' }),
  });

  // ---- the dialog

  function build() {
    const { input, list, said } = oddity.searched('hits', 'Search', 'pendulum, 3.19, spring energy, Runge-Kutta \u2026');
    dialog = oddity.element('dialog', { class: 'search', 'aria-label': 'Search' }, input, said, list);
    dialog.finder = oddity.finder({ input, list, say: (text) => { said.textContent = text; }, opened: () => dialog.close(),
      idle: 'Exercises, claims, quantities, methods and pages; several words narrow it down.' });
    dialog.addEventListener('click', (event) => { if (event.target === dialog) dialog.close(); });
    document.body.append(dialog);
  }

  function open() {
    if (!dialog) build();
    if (!dialog.open) dialog.showModal();
    dialog.querySelector('input').select();
    dialog.finder.show();
  }

  const writes = (target) => target.isContentEditable || /^(INPUT|TEXTAREA|SELECT)$/.test(target.tagName);
  document.addEventListener('keydown', (event) => {
    if (event.key !== '/' || event.ctrlKey || event.metaKey || event.altKey || writes(event.target)) return;
    event.preventDefault();
    open();
  });

  const button = oddity.element('button', { type: 'button', class: 'find', 'aria-keyshortcuts': '/' }, 'Search ',
    oddity.element('kbd', {}, '/'));
  button.addEventListener('click', open);
  document.querySelector('.banner').append(button);
})(window.oddity = window.oddity || {});
