// Search over exercises, claims and quantities. The index, data/search.js, is loaded when it is first asked for.
(function (oddity) {
  'use strict';

  const most = 40;
  let entries = null, dialog = null, input = null, list = null, chosen = -1;

  // Called by data/search.js.
  oddity.index = async (packed) => {
    const all = await oddity.unpacked(packed);
    const names = new Map(all.filter(([, kind]) => kind === 'exercise').map(([to, , title]) => [to, title]));
    entries = all.map(([to, kind, named, text]) => {
      const [page, place] = to.split('#');
      const title = named || place;
      return { to, kind, title, text, words: `${title} ${text} ${kind} ${names.get(page)}`.toLowerCase() };
    });
    show();
  };

  function load_index() {
    if (entries || document.querySelector('script[src="data/search.js"]')) return;
    const script = document.createElement('script');
    script.src = 'data/search.js';
    script.onerror = () => say('The index, data/search.js, is not there.');
    document.body.append(script);
  }

  // Every word has to be in an entry; what is in its title, and wrong, comes first.
  function found(query) {
    const words = query.toLowerCase().split(/\s+/).filter(Boolean);
    const weight = (entry) => {
      const title = entry.title.toLowerCase();
      const ranks = { exercise: 4, wrong: 3, incomplete: 2, misprint: 2, quantity: 1 };
      return words.reduce((sum, word) => sum + (title.startsWith(word) ? 12 : title.includes(word) ? 6 : 0), 0) + (ranks[entry.kind] || 0);
    };
    return entries.filter((entry) => words.every((word) => entry.words.includes(word)))
      .map((entry) => [weight(entry), entry]).sort((a, b) => b[0] - a[0]).map(([, entry]) => entry);
  }

  function say(text) {
    dialog.querySelector('.said').textContent = text;
  }

  const brief = (text) => (text.length > 140 ? text.slice(0, text.lastIndexOf(' ', 137)) + '...' : text);

  function item_of(entry, place) {
    const item = oddity.element('li', { role: 'option', id: `hit-${place}`, 'aria-selected': 'false' },
      oddity.element('a', { href: entry.to, tabindex: '-1' },
        oddity.element('b', { class: `kind ${entry.kind.replace(/\W/g, '-')}` }, entry.kind), ' ',
        oddity.element('span', {}, entry.title),
        oddity.element('small', {}, brief(entry.text))));
    item.addEventListener('click', () => dialog.close());
    return item;
  }

  function show() {
    if (!dialog || !entries) return;
    const query = input.value.trim(), hits = query ? found(query) : [];
    list.replaceChildren(...hits.slice(0, most).map(item_of));
    choose(hits.length > 0 ? 0 : -1);
    say(!query ? 'Exercises, claims and quantities; several words narrow it down.'
      : hits.length === 0 ? 'Nothing has all these words.'
        : hits.length > most ? `${hits.length} found, the first ${most} shown` : `${hits.length} found`);
  }

  function choose(place) {
    const items = list.children;
    if (items[chosen]) items[chosen].setAttribute('aria-selected', 'false');
    chosen = Math.max(-1, Math.min(place, items.length - 1));
    if (chosen < 0) {
      input.removeAttribute('aria-activedescendant');
      return;
    }
    items[chosen].setAttribute('aria-selected', 'true');
    items[chosen].scrollIntoView({ block: 'nearest' });
    input.setAttribute('aria-activedescendant', items[chosen].id);
  }

  function on_key(event) {
    const moves = { ArrowDown: 1, ArrowUp: -1 };
    if (event.key in moves) {
      event.preventDefault();
      choose(Math.max(0, chosen + moves[event.key]));
    } else if (event.key === 'Enter' && list.children[chosen]) {
      event.preventDefault();
      list.children[chosen].querySelector('a').click();
    }
  }

  function build() {
    input = oddity.element('input', {
      type: 'search', 'aria-label': 'Search', placeholder: 'pendulum, 3.19, spring energy, misprint …', role: 'combobox',
      'aria-expanded': 'true', 'aria-controls': 'hits', 'aria-autocomplete': 'list', autocomplete: 'off', spellcheck: 'false',
    });
    list = oddity.element('ul', { id: 'hits', role: 'listbox', 'aria-label': 'What was found' });
    dialog = oddity.element('dialog', { class: 'search', 'aria-label': 'Search' }, input,
      oddity.element('p', { class: 'said', 'aria-live': 'polite' }), list);
    input.addEventListener('input', show);
    dialog.addEventListener('keydown', on_key);
    dialog.addEventListener('click', (event) => { if (event.target === dialog) dialog.close(); });
    document.body.append(dialog);
  }

  function open() {
    if (!dialog) build();
    if (!dialog.open) dialog.showModal();
    load_index();
    input.select();
    show();
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
