// The players, charts and the chooser, used as a reader uses them.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, open, scenes } from './browser.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const clock = (page) => page.$eval('.player-clock', (place) => parseFloat(place.textContent.replace(/^t = /, '')));
const worst = (page) => page.$eval('.player-rows', (rows) => rows.innerText.match(/at worst\s+([^\s]+)/)?.[1]);
const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

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

test('a slider changes every method of its scene', async () => {
  const { page, faults } = await open(browser, '3.5.html', { reduced: true });
  await page.waitForSelector('.player-parameters input[type=range]');
  const before = await worst(page);
  await page.focus('.player-parameters input[type=range]');
  for (let i = 0; i < 20; ++i) await page.keyboard.press('ArrowRight');
  await wait(300);
  assert.notEqual(await worst(page), before);
  assert.deepEqual(faults, []);
  await page.close();
});

test('a trial of the chart plays, and its row lights', async () => {
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

test('a damaged link gives a message and the player as it opens', async () => {
  for (const hash of ['play&p.a=much', 'play&p.b=1', 'play&p.a=1e9', 'play&row=one%20angle/magic/double/0.1', 'play&row=%', 'play&at=<script>']) {
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
  await page.waitForFunction(() => /oddity choose 3\.5/.test(document.querySelector('.chooser').innerText), { timeout: 20000 });
  assert.deepEqual(faults, []);
  await page.close();
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
