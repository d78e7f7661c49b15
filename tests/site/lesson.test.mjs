// The lesson: one view, explained step by step with keys, moved by dragging, and printed.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, open, overlaps, shoot } from './browser.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

async function lesson(at, options = {}) {
  const opened = await open(browser, `lesson.html#${at}`, { width: 1366, height: 768, reduced: true, ...options });
  await opened.page.waitForFunction(() => window.oddity.lesson);
  return opened;
}
const now = (page) => page.$eval('.told > .now', (step) => step.dataset.name);
const set = async (page, label, value) => {
  const field = await page.$(`.lesson-controls input[aria-label="${label}, typed"]`);
  await field.click({ clickCount: 3 });
  await page.keyboard.type(String(value));
  await page.keyboard.press('Enter');
};

test('the arrow keys go through the steps and back, and stay in a slider', async () => {
  const { page, faults } = await lesson('circle');
  const all = await page.$$eval('.told > li', (steps) => steps.map((step) => step.dataset.name));
  assert.ok(all.length >= 6);
  const told = [];
  for (const id of all) {
    assert.equal(await now(page), id);
    told.push(await page.$eval('.told', (steps) => steps.innerText));
    assert.match(page.url(), new RegExp(`#${id}$`));
    await page.keyboard.press('ArrowRight');
  }
  assert.ok(told.every((text) => /Try:/.test(text)) && new Set(told).size === all.length);
  for (const id of all.slice(0, -1).reverse()) {
    await page.keyboard.press('ArrowLeft');
    assert.equal(await now(page), id);
  }
  await page.keyboard.press('ArrowRight');
  await page.focus('.lesson-controls input[type=range]');
  await page.keyboard.press('ArrowRight');
  assert.equal(await now(page), all[1]);
  assert.deepEqual(faults, []);
  await page.close();
});

for (const [width, height] of [[1366, 768], [768, 1024], [390, 844]])
  test(`no two texts overlap at any step, ${width} px wide`, async () => {
    const { page, faults } = await lesson('circle', { width, height });
    const count = (await page.$$('.told > li')).length;
    for (let i = 0; i < count; ++i) {
      assert.deepEqual(await overlaps(page), []);
      if (height === 768) {
        const bottom = await page.$eval('.lesson', (all) => all.getBoundingClientRect().bottom);
        assert.ok(bottom <= height, `${await now(page)} ends at ${bottom} px`);
      }
      await shoot(page, `lesson-${i}-${width}`);
      await page.keyboard.press('ArrowRight');
    }
    assert.deepEqual(faults, []);
    await page.close();
  });

test('the numbers are those of the formulas in the text', async () => {
  const { page, faults } = await lesson('one-step');
  const of = (name) => page.$eval('.lesson', (all, key) => Number(all.dataset[key]), name);
  for (const h of [0.25, 0.125, 1]) {
    await set(page, 'h, step', h);
    const factor = await of('factor'), right = 1 + (2 * h) ** 2;
    assert.ok(Math.abs(factor - right) <= 1e-14 * right, `${factor} at ${h} s`);
  }
  for (const id of ['symplectic', 'verlet']) {
    await page.evaluate((to) => { location.hash = to; }, id);
    await page.waitForFunction((to) => document.querySelector('.told > .now').dataset.name === to, {}, id);
    for (const h of [0.5, 0.9]) {
      await set(page, 'h, step', h);
      assert.ok(await of('shadow') <= 1e-12, `${id} at ${h} s`);
    }
    await set(page, 'h, step', 1.1);
    assert.match(await page.$eval('.lesson-readings', (text) => text.textContent), /each step/);
  }
  assert.deepEqual(faults, []);
  await page.close();
});

test('the mass can be dragged, and so can the point on the circle', async () => {
  const { page, faults } = await lesson('circle');
  const start = () => page.$eval('.lesson-controls input[aria-label="x0, place at the start, typed"]', (field) => Number(field.value));
  for (const place of ['.lesson-stage canvas', '.lesson-circle svg']) {
    const before = await start();
    const { x, y, width, height } = await (await page.$(place)).boundingBox();
    await page.mouse.move(x + 0.5 * width, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + (before > 0 ? 0.3 : 0.7) * width, y + height / 2, { steps: 4 });
    await page.mouse.up();
    assert.ok(before > 0 ? await start() < 0 : await start() > 0, `${place}: ${before} and then ${await start()}`);
  }
  assert.deepEqual(faults, []);
  await page.close();
});

test('the lesson fills the screen', async () => {
  const { page, faults } = await lesson('spiral');
  await page.evaluate(() => [...document.querySelectorAll('.lesson button')].find((b) => b.textContent === 'Full screen').focus());
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.fullscreenElement === document.querySelector('.lesson'));
  assert.deepEqual(faults, []);
  await page.close();
});

test('printed, it is a handout of at most two pages with every step and its charts', async () => {
  for (const scripts of [true, false]) {
    const { page } = scripts ? await lesson('verlet') : await open(browser, 'lesson.html', { scripts: false });
    await page.emulateMediaType('print');
    const steps = await page.$$eval('.told > li', (all) => all.map((step) => ({ id: step.dataset.name, height: step.getBoundingClientRect().height,
      chart: step.querySelector('.still')?.getBoundingClientRect().height ?? 0 })));
    assert.ok(steps.every(({ height }) => height > 20) && steps.filter(({ chart }) => chart > 20).length === steps.length - 1, JSON.stringify(steps));
    const pdf = Buffer.from(await page.pdf({ format: 'A4' })).toString('latin1');
    const count = (pdf.match(/\/Type\s*\/Page\b/g) ?? []).length;
    assert.ok(count >= 1 && count <= 2, `${count} pages`);
    await page.close();
  }
});
