// The front page's field: "3.17" or "pendulum" goes to the exercise's page.
(function (oddity) {
  'use strict';

  const place = document.querySelector('.ask');
  const numbered = /^\s*(\d+\s*[.,]\s*\d+)\s*$/;
  const tiles = new Map([...document.querySelectorAll('.tile')].map((tile) => [tile.firstChild.textContent.trim(), tile]));
  const { input, list, said } = oddity.searched('asked', 'Number or topic of an exercise', '3.17 or pendulum');
  const go = oddity.element('button', { type: 'button' }, 'Go');
  const asked = () => (numbered.exec(input.value) || ['', ''])[1].replace(/\s/g, '').replace(',', '.');
  const isExercise = ({ kind, page }) => kind === 'exercise' && tiles.has(page.replace(/\.html$/, ''));

  function say(text) {
    const number = asked();
    said.textContent = number && !tiles.has(number) ? `There is no page for ${number}: the manual solves the odd exercises.` : text;
    list.hidden = !list.children.length;
    input.setAttribute('aria-expanded', String(!list.hidden));
  }
  function close() {
    list.replaceChildren();
    list.hidden = true;
    input.setAttribute('aria-expanded', 'false');
  }

  const finder = oddity.finder({ input, list, say, fits: isExercise, limit: 6 });
  go.addEventListener('click', () => {
    if (tiles.has(asked())) tiles.get(asked()).click();
    else if (list.children.length) finder.follow();
    else finder.show();
  });
  input.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') close();
    if (event.key !== 'Enter' || !tiles.has(asked())) return;
    event.stopImmediatePropagation();
    tiles.get(asked()).click();
  }, true);
  place.addEventListener('focusout', (event) => { if (!place.contains(event.relatedTarget)) setTimeout(close, 200); });
  close();
  place.append(input, go, said, list);
})(window.oddity = window.oddity || {});
