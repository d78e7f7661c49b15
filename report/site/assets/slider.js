// A slider with a text field, and helpers for the player's elements.

(function (oddity) {
  'use strict';

  const svg = 'http://www.w3.org/2000/svg';

  function attributes(element, all) {
    for (const [name, value] of Object.entries(all)) {
      if (value === undefined || value === false) continue;
      if (typeof value === 'function') element.addEventListener(name, value);
      else element.setAttribute(name, value === true ? '' : value);
    }
    return element;
  }

  /** Makes an element with attributes, and listeners for values that are functions; children are elements or
      text. */
  oddity.make = function (tag, all = {}, ...children) {
    const element = attributes(document.createElement(tag), all);
    element.append(...children.filter((c) => c !== null));
    return element;
  };

  /** A drawing of 16 by 16 pixels. */
  oddity.icon = function (...paths) {
    const drawing = attributes(document.createElementNS(svg, 'svg'),
      { viewBox: '0 0 16 16', width: 16, height: 16, 'aria-hidden': 'true', focusable: 'false' });
    for (const path of paths) {
      const shape = typeof path === 'string' ? { d: path } : path;
      drawing.append(attributes(document.createElementNS(svg, 'path'), shape));
    }
    return drawing;
  };

  const places = 1000;
  let made = 0;

  /** {element, show(value), enable(yes)}. `units` are accepted in the field. `changed(value)` receives a new
      value; `refused(text)` the reason why a typed text, which stays there, is invalid. */
  oddity.slider = function ({ name, says, unit, units = {}, scale, value, checked, changed, refused }) {
    const id = `slider-${made += 1}`;
    const label = says ? `${name}, ${says}` : name;
    const range = oddity.make('input', { type: 'range', id, min: 0, max: places, step: 1, 'aria-label': label });
    const field = oddity.make('input', { type: 'text', inputmode: 'decimal', class: 'slider-value', autocomplete: 'off',
      spellcheck: 'false', 'aria-label': `${label}, typed` });
    const words = [oddity.make('span', { class: 'slider-name' }, says ? oddity.letter(name) : name)];
    if (says) words.push(oddity.make('span', { class: 'slider-says', title: says }, says));
    const element = oddity.make('div', { class: 'slider' },
      oddity.make('label', { for: id }, ...words), oddity.make('span', { class: 'slider-unit' }, oddity.unitName(unit)),
      range, field);

    let now = value;
    function show(x) {
      now = x;
      range.value = Math.round(places * scale.place(x));
      range.setAttribute('aria-valuetext', `${oddity.inField(x)} ${unit}`.trim());
      if (document.activeElement !== field) field.value = oddity.inField(x);
      field.removeAttribute('aria-invalid');
    }

    function type() {
      let x, problem;
      try {
        x = oddity.number(field.value, unit, units);
        problem = checked(x);
      } catch (error) {
        problem = `${error.message}.`;
      }
      if (problem) {
        field.setAttribute('aria-invalid', 'true');
        refused(problem);
      } else if (field.value !== oddity.inField(now)) {
        field.removeAttribute('aria-invalid');
        field.blur();
        changed(x);
      }
    }

    range.addEventListener('input', () => changed(scale.value(range.value / places)));
    field.addEventListener('change', type);
    field.addEventListener('blur', () => { if (!field.hasAttribute('aria-invalid')) field.value = oddity.inField(now); });
    show(value);
    return { element, show, enable(yes) { range.disabled = !yes; field.disabled = !yes; } };
  };
})(window.oddity = window.oddity || {});
