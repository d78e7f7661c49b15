// The claims of a problem's file, each with its verdict, judged one after the other while the page is free.

(function (oddity) {
  'use strict';

  const { make } = oddity;

  function evidence({ reading, holds, text, where }) {
    return make('li', {}, `${reading} ${holds ? 'holds' : 'fails'}: ${text}${where ? `, ${where}` : ''}`);
  }

  function row(claim) {
    if (claim.wrong) return make('li', { class: 'own-claim' }, claim.wrong);
    const { says, printed, verdict, expected, why, checks } = claim;
    const asSaid = verdict === expected;
    return make('li', { class: `own-claim ${asSaid ? 'as-said' : 'not-as-said'}` },
      make('p', {}, make('b', {}, verdict), ` ${says}: `, make('code', {}, printed)),
      asSaid ? '' : make('p', {}, `The file says that this is ${expected}.`), why ? make('p', {}, why) : '',
      make('details', {}, make('summary', {}, 'What is compared'), make('ul', {}, ...checks.map(evidence))));
  }

  /** Fills `place` with `count` claims, as long as `go()` is true: the file is still the same. */
  oddity.showClaims = function (place, count, go, done) {
    const list = make('ol', {});
    place.replaceChildren(make('h2', {}, 'Its claims'), list);
    let next = 0;
    const step = () => {
      if (!go()) return;
      if (next === count) return done();
      list.append(row(oddity.engine.claim(next)));
      next += 1;
      setTimeout(step, 0);
    };
    setTimeout(step, 0);
  };
})(window.oddity = window.oddity || {});
