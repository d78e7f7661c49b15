// The front page's doors: readers' questions, visible at once, and the field that leads to an exercise.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, open, overlaps, pages } from './browser.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

test('three doors and a moving picture are visible at once on a laptop', async () => {
  const { page, faults } = await open(browser, 'index.html', { width: 1366, height: 768, reduced: true });
  const doors = await page.$$eval('.door', (all) => all.map((door) => ({ asks: door.querySelector('h2').textContent, bottom: door.getBoundingClientRect().bottom })));
  for (const asks of ['Is my exercise right?', 'Why does Euler fail?', 'What do I use?'])
    assert.ok(doors.some((door) => door.asks === asks), `no door asks ${asks}`);
  assert.ok(doors.every(({ bottom }) => bottom <= 768), JSON.stringify(doors));
  assert.ok(await page.$eval('.door .thumb', (picture) => picture.querySelectorAll('animate').length > 0));
  assert.deepEqual(faults, []);
  await page.close();
});

test('every exercise has a tile in the colour of its worst verdict', async () => {
  const front = await open(browser, 'index.html', { reduced: true });
  const tiles = await front.page.$$eval('.tile', (all) => all.map((tile) => ({ to: tile.getAttribute('href'), kind: tile.classList[1] })));
  await front.page.close();
  assert.deepEqual(tiles.map(({ to }) => to).sort(), pages.filter((name) => /^\d+\.\d+\.html$/.test(name)).sort());
  for (const { to, kind } of tiles) {
    const { page } = await open(browser, to, { reduced: true, scripts: false });
    const found = await page.$$eval('.counts .badge', (all) => all.map((badge) => badge.classList[1]));
    const worst = ['wrong', 'incomplete', 'unsettled', 'misprint'].find((one) => found.includes(one)) ?? 'right';
    assert.equal(kind, worst, to);
    await page.close();
  }
});

for (const [typed, to] of [['3.17', /\/3\.17\.html/], ['3,17', /\/3\.17\.html/], ['pendulum', /\/3\.\d+\.html/], ['pendlum', /\/3\.\d+\.html/]])
  test(`the field goes to the exercise: ${typed}`, async () => {
    const { page, faults } = await open(browser, 'index.html', { reduced: true });
    await page.type('.ask input', typed);
    await Promise.all([page.waitForNavigation(), page.keyboard.press('Enter')]);
    assert.match(page.url(), to);
    assert.match(await page.$eval('h1', (title) => title.textContent), typed.startsWith('p') ? /pendulum/i : /3\.17/);
    assert.deepEqual(faults, []);
    await page.close();
  });

test('the field reports an exercise that does not exist', async () => {
  const { page, faults } = await open(browser, 'index.html', { reduced: true });
  await page.type('.ask input', '3.18');
  await page.waitForFunction(() => /no page for 3\.18/.test(document.querySelector('.ask .said').textContent));
  await page.keyboard.press('Enter');
  assert.match(page.url(), /index\.html/);
  assert.deepEqual(faults, []);
  await page.close();
});

for (const [typed, to] of [['Runge-Kutta', 'algorithms.html'], ['rungekuta 4', null], ['Verlet', 'algorithms.html'], ['Euler fails', 'lesson.html'], ['pendlum', '3.5.html']])
  test(`the search finds: ${typed}`, async () => {
    const { page, faults } = await open(browser, 'errata.html', { reduced: true });
    await page.keyboard.press('/');
    await page.keyboard.type(typed);
    await page.waitForFunction(() => /found|Nothing/.test(document.querySelector('dialog[open] .said').textContent));
    const hits = await page.$$eval('dialog[open] li a', (all) => all.map((a) => a.getAttribute('href').split('#')[0]));
    assert.equal(to === null ? hits.length === 0 : hits.includes(to), true, hits.join(' '));
    assert.deepEqual(faults, []);
    await page.close();
  });

for (const width of [390, 768, 1366])
  test(`no two texts of the front page overlap, ${width} px wide`, async () => {
    const { page, faults } = await open(browser, 'index.html', { width, height: 768, reduced: true });
    assert.deepEqual(await overlaps(page), []);
    assert.deepEqual(faults, []);
    await page.close();
  });
