// The players, charts and the chooser, used like a reader does.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, open, scenes, shoot, solved } from './browser.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const clock = (page) => page.$eval('.player-clock', (place) => parseFloat(place.textContent.replace(/^t = /, '')));
const worst = (page) => page.$eval('.player-rows', (rows) => rows.innerText.match(/at worst\s+([^\s]+)/)?.[1]);

/// The times between frames, in ms, while it plays.
const frames = (page, ms) => page.evaluate((length) => new Promise((resolve) => {
  const gaps = [];
  const start = performance.now();
  let before = start;
  const next = (now) => {
    gaps.push(now - before);
    before = now;
    if (now - start < length) requestAnimationFrame(next);
    else resolve(gaps.slice(1));
  };
  requestAnimationFrame(next);
}), ms);

for (const scene of scenes)
  test(`${scene}: the player plays`, async (t) => {
    const { page, faults } = await open(browser, `${scene}.html`);
    await page.waitForSelector('.player-clock');
    await page.$eval('.player', (player) => player.scrollIntoView({ block: 'center' }));
    await page.waitForFunction(() => parseFloat(document.querySelector('.player-clock').textContent.replace(/^t = /, '')) > 0);
    const gaps = (await frames(page, 5000)).sort((a, b) => a - b);
    t.diagnostic(`p99 of ${gaps.length} frames: ${gaps[Math.floor(0.99 * gaps.length)].toFixed(1)} ms`);
    assert.ok(gaps.length > 0);
    assert.ok(Number.isFinite(await clock(page)));
    assert.deepEqual(faults, []);
    await page.close();
  });

test('how long four methods take when a slider moves', async (t) => {
  for (const scene of scenes) {
    const { page } = await open(browser, `${scene}.html`, { reduced: true });
    await page.waitForSelector('.player-rows [data-end]');
    if (!(await page.$('.player-parameters input[type=range]:not([disabled])'))) { await page.close(); continue; }
    await page.$$eval('.player-actions button', (all) => {
      const add = all.find((one) => one.textContent === 'add a method');
      while (!add.disabled) add.click();
    });
    await page.focus('.player-parameters input[type=range]');
    const took = [];
    for (let i = 0; i < 10; ++i) {
      await page.keyboard.press('ArrowRight');
      await page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));
      took.push(Number(await page.$eval('.player', (player) => player.dataset.computed)));
    }
    took.sort((a, b) => a - b);
    t.diagnostic(`${scene}: ${took[5]} ms, at most ${took[9]} ms`);
    await page.close();
  }
});

test('a slider changes every method of its scene', async () => {
  const { page, faults } = await open(browser, '3.5.html', { reduced: true });
  await page.waitForSelector('.player-parameters input[type=range]');
  const before = await worst(page);
  await page.focus('.player-parameters input[type=range]');
  for (let i = 0; i < 20; ++i) await page.keyboard.press('ArrowRight');
  await page.waitForFunction((was) => document.querySelector('.player-rows').innerText.match(/at worst\s+([^\s]+)/)?.[1] !== was, {}, before);
  assert.deepEqual(faults, []);
  await page.close();
});

test('frames as they come are the steps of the methods', async () => {
  const { page, faults } = await open(browser, '3.5.html#play&row=one%20angle/symplectic%20Euler/double/0.0166666667', { reduced: true });
  await page.waitForSelector('.player-rows [data-end]');
  const before = await worst(page);
  await page.select('.player-frames select', 'both');
  await page.waitForFunction((was) => document.querySelector('.player-rows').innerText.match(/at worst\s+([^\s]+)/)?.[1] !== was, {}, before);
  assert.match(await linked(page), /&frames=both/);
  assert.deepEqual(faults, []);
  await page.close();
});

/// The address made by 'copy link'.
async function linked(page) {
  await page.$$eval('.player-actions button', (all) => all.find((b) => b.textContent === 'copy link').click());
  return page.evaluate(() => window.location.hash);
}

/// Distance of two places in each of the norms' units.
function distances(a, b, norms) {
  const far = new Map();
  for (const { unit, components } of norms)
    far.set(unit, Math.max(far.get(unit) ?? 0, Math.hypot(...components.map((k) => a[k] - b[k]))));
  return [...far.values()];
}

// Without chaotic motions, which magnify differences of rounding.
for (const scene of ['3.5', '3.7', '3.9', '3.11', '3.15', '3.19', '3.27', '3.29', '3.31', '3.33'])
  test(`${scene}: a slider's values and errors are the program's`, async (t) => {
    const { page, faults } = await open(browser, `${scene}.html`, { reduced: true });
    const models = await page.evaluate((number) => window.oddity.engine.scene(number).models.map((model) => model.name), scene);
    const trial = solved(scene).trials.filter((one) => models.includes(one.model) && one.algorithm === 'Runge-Kutta 4'
      && one.precision === 'double' && one.outcome === 'ok').at(-1);
    const row = [trial.model, trial.algorithm, 'double', trial.resolution].map(encodeURIComponent).join('/');
    await page.evaluate((hash) => { window.location.hash = hash; }, `#play&row=${row}`);
    await page.waitForFunction(() => document.querySelector('.player-says').textContent === 'The player is set as in the link.');
    const before = await page.$eval('.player-rows [data-end]', (place) => place.dataset.end);
    await page.focus('.player-parameters input[type=range]');
    for (let i = 0; i < 7; ++i) await page.keyboard.press('ArrowRight');
    await page.waitForFunction((was) => document.querySelector('.player-rows [data-end]').dataset.end !== was, {}, before);
    await page.evaluate(() => new Promise((resolve) => { requestAnimationFrame(() => requestAnimationFrame(resolve)); }));
    const changed = [...(await linked(page)).matchAll(/&p\.(\w+)=([^&]*)/g)].map(([, name, value]) => `${name}=${value}`);
    assert.equal(changed.length, 1);
    const shown = JSON.parse(await page.$eval('.player-rows [data-end]', (place) => place.dataset.end));
    const norms = await page.evaluate(() => window.oddity.data.scene.norms);

    const there = solved(scene, ...changed);
    const same = there.trials.find((one) => ['model', 'algorithm', 'precision', 'resolution'].every((name) => one[name] === trial[name]));
    const count = shown.observed.length;
    const value = same.value.slice(-count);
    const size = Math.max(...same.value.map(Math.abs));
    const apart = Math.max(...value.map((x, k) => Math.abs(x - shown.observed[k])));
    const errors = distances(value, there.reference.slice(-count), norms);
    const errorsApart = Math.max(...errors.map((x, u) => Math.abs(x - shown.errors[u])));
    const known = Math.max(1e-9 * size, ...shown.floors);  // methods without nine digits report it
    t.diagnostic(`${changed[0]}: values ${(apart / size).toExponential(1)} apart, errors ${(errorsApart / size).toExponential(1)}, known to ${(known / size).toExponential(1)}`);
    assert.notDeepEqual(value, trial.value.slice(-count));
    assert.ok(apart <= 1e-9 * size, `${shown.observed} is not ${value}`);
    assert.ok(errorsApart <= known, `${shown.errors} is not ${errors}`);
    assert.deepEqual(faults, []);
    await page.close();
  });

test('2.7: an error is judged as in the table, by its largest component', async () => {
  const trial = solved('2.7').trials.find((one) => one.algorithm === 'explicit Euler' && one.final_error > 1e-4);
  const row = [trial.model, trial.algorithm, 'double', trial.resolution].map(encodeURIComponent).join('/');
  const { page, faults } = await open(browser, `2.7.html#play&row=${row}`, { reduced: true });
  const { errors } = JSON.parse(await page.$eval('.player-rows [data-end]', (place) => place.dataset.end));
  assert.ok(Math.abs(errors[0] - trial.final_error) < 1e-6, `${errors[0]} is not ${trial.final_error}`);
  assert.deepEqual(faults, []);
  await page.close();
});

test('a scene of one freedom has its phase portrait, which is drawn when it is opened', async () => {
  const { page, faults } = await open(browser, '3.5.html', { reduced: true });
  const isInked = () => {
    const canvas = document.querySelector('.player-portraits canvas'), blank = document.createElement('canvas');
    [blank.width, blank.height] = [canvas.width, canvas.height];
    return canvas.toDataURL() !== blank.toDataURL();
  };
  assert.equal(await page.evaluate(isInked), false);
  await page.click('.player-more:has(.player-portraits) summary');
  await page.waitForFunction(isInked, { timeout: 10000 });
  await shoot(page, '3.5-portrait');
  assert.deepEqual(faults, []);
  await page.close();
});

test('a link has the view of a scene in space', async () => {
  const { page, faults } = await open(browser, '3.33.html', { reduced: true });
  await page.waitForSelector('.player-rows [data-end]');
  assert.doesNotMatch(await linked(page), /view=/);
  await page.focus('.player-canvas');
  for (const key of ['ArrowLeft', 'ArrowLeft', 'ArrowUp']) await page.keyboard.press(key);
  const hash = await linked(page);
  assert.match(hash, /&view=18\.5,28\.2/);
  const again = await open(browser, `3.33.html${hash}`, { reduced: true });
  await again.page.waitForSelector('.player-rows [data-end]');
  assert.equal(await linked(again.page), hash);
  assert.deepEqual([...faults, ...again.faults], []);
  await page.close();
  await again.page.close();
});

test('the bouncing ball comes to rest, or chatters, when the true one rests', async () => {
  const { page, faults } = await open(browser, 'bouncing_ball.html', { reduced: true });
  const rows = () => page.$$eval('.player-rows > *', (all) => all.map((row) => row.innerText));
  const restOf = (e) => Math.sqrt(2 / 9.81) * (1 + e) / (1 - e);
  await page.waitForSelector('.player-rows [data-end]');
  const check = async (e) => {
    const [resting, ball, euler] = await rows();
    assert.match(resting, /holds 1 cm/);
    const [, until] = ball.match(/breaks off at ([\d.]+) s: chattering/);
    assert.ok(until >= restOf(e) - 0.005 && until <= restOf(e) + 1 / 60 + 0.005, `${until} is not ${restOf(e)}`);
    assert.doesNotMatch(euler, /chattering/);
  };
  await check(0.7);
  await page.focus('.player-parameters input[type=text]');
  await page.keyboard.down('Control');
  await page.keyboard.press('KeyA');
  await page.keyboard.up('Control');
  await page.keyboard.type('0.5');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => /1\.3\d s: chattering/.test(document.querySelector('.player-rows').innerText));
  await check(0.5);
  assert.deepEqual(faults, []);
  await page.close();
});

for (const name of ['3.5', '2.7', 'bouncing_ball'])
  test(`${name}: without scripts there are chart and table`, async () => {
    const { page } = await open(browser, `${name}.html`, { scripts: false, width: 390, height: 844 });
    await page.waitForSelector('.still svg');
    await page.waitForSelector('table.still td');
    assert.ok((await page.$$('.still svg .s1')).length > 0);
    assert.ok(await page.$eval('.still svg', (chart) => chart.getBoundingClientRect().height > 100));
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
    await shoot(page, `${name}-without-scripts`);
    await page.close();
  });

test('a trial of the chart plays, and its row is highlighted', async () => {
  const { page, faults } = await open(browser, '3.5.html', { reduced: true });
  const chart = await page.waitForSelector('figure.chart[data-quantity=swing]');
  await chart.scrollIntoView();
  const point = await page.waitForSelector('figure.chart[data-quantity=swing] svg [tabindex="0"]');
  await page.evaluate(() => document.addEventListener('oddity:play', (event) => { window.played = event.detail; }));
  await point.evaluate((node) => node.focus());
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  const played = await page.waitForFunction(() => window.played).then((handle) => handle.jsonValue());
  const row = await page.$eval('.player-rows', (rows) => [...rows.querySelectorAll('select')].map((s) => s.selectedOptions[0].textContent));
  assert.ok(row.includes(played.model), `${played.model} is none of ${row}`);
  assert.ok((await page.$$('figure.chart[data-quantity=swing] .lit')).length > 0);
  assert.deepEqual(faults, []);
  await page.close();
});

test('a row of the table plays, and its point in the chart is highlighted', async () => {
  const { page, faults } = await open(browser, '3.5.html', { reduced: true });
  const place = await page.waitForSelector('.trials[data-quantity=swing]');
  await place.scrollIntoView();
  const summary = await page.waitForSelector('.trials[data-quantity=swing] summary');
  await summary.click();
  const row = await page.waitForSelector('.trials[data-quantity=swing] tbody tr[data-outcome=o]:nth-child(n + 5)');
  await page.evaluate(() => document.addEventListener('oddity:play', (event) => { window.played = event.detail; }));
  await row.scrollIntoView();
  await row.click();
  const played = await page.waitForFunction(() => window.played).then((handle) => handle.jsonValue());
  assert.ok((await row.evaluate((node) => node.innerText)).includes(played.algorithm));
  assert.ok((await page.$$('figure.chart[data-quantity=swing] .lit')).length > 0);
  assert.deepEqual(faults, []);
  await page.close();
});

test('a cell of the map plays', async () => {
  const { page, faults } = await open(browser, '3.5.html', { reduced: true });
  await page.$eval('figure.map', (map) => map.scrollIntoView());
  const cell = await page.waitForSelector('figure.map .panel td.cell-X');
  await page.evaluate(() => document.addEventListener('oddity:play', (event) => { window.played = event.detail; }));
  await cell.scrollIntoView();
  await cell.click();
  const played = await page.waitForFunction(() => window.played).then((handle) => handle.jsonValue());
  assert.equal(played.algorithm, await cell.evaluate((node) => node.closest('.panel').querySelector('p').textContent));
  await page.waitForFunction((name) => [...document.querySelectorAll('.player-rows select')]
    .some((s) => s.selectedOptions[0].textContent.startsWith(name)), {}, played.algorithm);
  assert.ok((await page.$$('figure.map .lit')).length > 0);
  assert.deepEqual(faults, []);
  await page.close();
});

test('cells of the map that roundings decide are marked, and so is the legend', async () => {
  const { page, faults } = await open(browser, '3.3.html', { reduced: true });
  await page.$eval('figure.map', (map) => map.scrollIntoView());
  await page.waitForSelector('figure.map .panel td.fragile');
  const marked = await page.$$eval('figure.map .panel td.fragile', (cells) => cells.map((c) => c.getAttribute('aria-label')));
  assert.ok(marked.length < 10 && marked.every((label) => label.endsWith(', by roundings')), marked.join('; '));
  assert.ok(await page.$eval('.map-legend .fragile', (cell) => cell.getBoundingClientRect().height > 10));
  assert.deepEqual(faults, []);
  await page.close();
});

test('engines play next to the models, if they have been run', async (t) => {
  const { page, faults } = await open(browser, '3.5.html', { reduced: true });
  await page.waitForSelector('.player-rows [data-end]');
  const pressed = await page.$$eval('.player-actions button', (all) => {
    const one = all.find((b) => b.textContent === 'as engines do');
    if (one) one.click();
    return !!one;
  });
  if (pressed) {
    const rows = await page.$$eval('.player-rows > *', (all) => all.map((row) => row.innerText));
    assert.ok(rows.length >= 2 && rows.slice(1).every((row) => /recorded/.test(row)), rows.join('; '));
    assert.ok(rows.every((row) => /at worst/.test(row)), rows.join('; '));
  } else t.diagnostic('no engine has been run: ./oddity engines');
  assert.deepEqual(faults, []);
  await page.close();
});

test('a player can be operated by keys alone', async () => {
  const { page, faults } = await open(browser, '3.5.html', { reduced: true });
  await page.waitForSelector('.player-rows [data-end]');
  const at = () => page.evaluate(() => {
    const { outlineStyle, outlineWidth, boxShadow } = getComputedStyle(document.activeElement);
    return { text: document.activeElement.textContent, inPlayer: !!document.activeElement.closest('.player'),
      play: document.activeElement.classList.contains('player-play'),
      seen: (outlineStyle !== 'none' && parseFloat(outlineWidth) > 0) || boxShadow !== 'none' };
  });
  const reached = [];
  let outside = 0;
  for (let i = 0; i < 400 && (outside < 5 || !reached.length); ++i) {
    await page.keyboard.press('Tab');
    const place = await at();
    if (!place.inPlayer) { if (reached.length) ++outside; continue; }
    assert.ok(place.seen, `no focus is seen at ${place.text}`);
    reached.push(place);
    if (place.play) {
      const before = await clock(page);
      await page.keyboard.press('Space');
      await page.waitForFunction((t) => parseFloat(document.querySelector('.player-clock').textContent.replace(/^t = /, '')) !== t, {}, before);
      await page.keyboard.press('Space');
    }
    if (place.text === 'break it') {
      await page.keyboard.press('Enter');
      await page.waitForFunction(() => document.querySelector('.player-says').textContent.length > 0);
    }
  }
  assert.ok(reached.some((place) => place.play) && reached.some((place) => place.text === 'break it'));
  const all = await page.$$eval('.player :is(button, select, input, canvas[tabindex="0"])', (them) => them
    .filter((one) => !one.disabled && one.offsetParent !== null && !(one.tabIndex < 0)).length);
  assert.ok(reached.length >= all, `${reached.length} of ${all} controls are reached`);
  assert.deepEqual(faults, []);
  await page.close();
});

test('a damaged link gives a message and the player as it first opens', async () => {
  for (const hash of ['play&p.a=much', 'play&p.b=1', 'play&p.a=1e9', 'play&row=one%20angle/magic/double/0.1', 'play&row=%', 'play&at=<script>', 'play&view=1,2', 'play&%zz']) {
    const { page, faults } = await open(browser, `3.5.html#${hash}`, { reduced: true });
    await page.waitForSelector('.player-rows select');
    const said = await page.$eval('.player', (player) => player.innerText);
    assert.match(said, /The link /, `nothing is said of #${hash}`);
    assert.deepEqual(faults, []);
    await page.close();
  }
});

test('the chooser answers with a command', async () => {
  const { page, faults } = await open(browser, 'chooser.html#scene=3.5');
  await page.waitForFunction(() => /oddity choose 3\.5/.test(document.querySelector('.chooser').innerText));
  assert.deepEqual(faults, []);
  await page.close();
});

/// Types a refused text into a field, and then an accepted one.
async function refuse(page, field, shown, bad, good) {
  const type = async (text) => {
    await page.focus(field);
    await page.$eval(field, (input) => input.select());
    await page.keyboard.type(text);
    await page.keyboard.press('Enter');
  };
  await type(bad);
  await page.waitForSelector(`${shown}.stale`);
  const said = await page.$eval(shown, (place) => place.innerText);
  assert.match(said, /has a unit that does not fit: rad, mrad, deg do/);
  await type(good);
  await page.waitForFunction((place) => !document.querySelector(place).matches('.stale'), {}, shown);
}

test('a number may have a unit; one that is refused greys the old answer', async () => {
  const { page, faults } = await open(browser, '3.5.html', { reduced: true });
  await page.waitForSelector('.player-rows select');
  await refuse(page, '.player-parameters .slider-value', '.player', '2cm', '60deg');
  await page.evaluate(() => document.activeElement.blur());
  assert.equal(await page.$eval('.player-parameters .slider-value', (field) => field.value), '1.0472');
  await page.close();
  const chooser = await open(browser, 'chooser.html#scene=3.5');
  await refuse(chooser.page, '.chooser fieldset input', '.chooser', '2cm', '60deg');
  await chooser.page.waitForFunction(() => /\.\/oddity choose 3\.5 a=1\.04719755/.test(document.querySelector('.chooser').innerText));
  assert.deepEqual([...faults, ...chooser.faults], []);
  await chooser.page.close();
});

test('the search is reached by a key and goes to a claim', async () => {
  const { page, faults } = await open(browser, 'index.html', { reduced: true });
  await page.keyboard.press('/');
  await page.keyboard.type('two pulleys');
  await page.waitForFunction(() => document.querySelector('dialog[open] li, dialog[open] a'));
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => /3\.19/.test(location.href));
  assert.deepEqual(faults, []);
  await page.close();
});

test('printed, the errata sheet is a few pages without navigation', async () => {
  const { page } = await open(browser, 'errata.html', { reduced: true });
  const pdf = await page.pdf({ format: 'A4' });
  const count = (Buffer.from(pdf).toString('latin1').match(/\/Type\s*\/Page\b/g) ?? []).length;
  assert.ok(count >= 3 && count <= 12, `${count} pages`);
  await page.close();
});

test('printed, the player shows its curves to the end, undistorted', async () => {
  const { page, faults } = await open(browser, '3.5.html', { reduced: true });
  await page.waitForSelector('.player-lines');
  const painted = () => page.$$eval('.player-curves .player-lines', (all) => all.map((canvas) => canvas.toDataURL()));
  const now = await painted();
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  const whole = await painted();
  whole.forEach((picture, k) => assert.notEqual(picture, now[k]));
  await page.evaluate(() => window.dispatchEvent(new Event('afterprint')));
  assert.deepEqual(await painted(), now);
  await page.emulateMediaType('print');
  const stretched = await page.$$eval('.player canvas', (all) => all.filter((canvas) => canvas.clientWidth)
    .map((canvas) => canvas.clientWidth / canvas.clientHeight / (canvas.width / canvas.height)));
  stretched.forEach((ratio) => assert.ok(Math.abs(ratio - 1) < 0.02, `${ratio}`));
  assert.deepEqual(faults, []);
  await page.close();
});
