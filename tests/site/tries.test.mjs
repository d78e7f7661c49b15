// Three readers' goals, from the front page on a laptop: the number of clicks, and the resulting view.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, open, shoot } from './browser.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const front = async () => {
  const { page } = await open(browser, 'index.html', { width: 1366, height: 768, reduced: true });
  return page;
};
const follow = (page, link) => Promise.all([page.waitForNavigation(), page.click(link)]);
/// Whether it is seen without scrolling.
const isSeen = (page, what) => page.$eval(what, (element) => {
  const { top, bottom, height } = element.getBoundingClientRect();
  return height > 0 && top >= 0 && bottom <= window.innerHeight;
});

test('a student: is 7.1 right, and why? A number and a key', async () => {
  const page = await front();
  await page.type('.ask input', '7.1');
  await Promise.all([page.waitForNavigation(), page.keyboard.press('Enter')]);
  await shoot(page, 'try-student');
  assert.ok(await isSeen(page, '.verdict'));
  assert.ok((await page.$eval('.verdict', (verdict) => verdict.textContent)).length > 20);
  await page.close();
});

test("a teacher: explicit Euler's spiral. A click and a key", async () => {
  const page = await front();
  await follow(page, '.door a[href="lesson.html"]');
  await page.waitForFunction(() => window.oddity.lesson);
  while (!/spiral/i.test(await page.$eval('.told > .now', (step) => step.textContent))) await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => document.querySelector('.way').getAttribute('points').split(' ').length > 3);
  await shoot(page, 'try-teacher');
  assert.ok(await isSeen(page, '.lesson'));
  await page.close();
});

for (const language of ['C++', 'C#'])
  test(`a programmer: the top's code in ${language}. Four clicks`, async () => {
    const page = await front();
    await follow(page, '.door a[href="recipes.html"]');
    await follow(page, 'a[href="3.33.html#recipe"]');
    const code = `details:has(pre[data-language="${language}"])`;
    await page.waitForSelector(`${code} button`);
    assert.ok(await isSeen(page, `${code} > summary`));
    await page.click(`${code} > summary`);
    await page.evaluate(() => { navigator.clipboard.writeText = async (text) => { window.copied = text; }; });
    await page.click(`${code} button`);
    await shoot(page, `try-programmer-${language === 'C#' ? 'cs' : 'cpp'}`);
    assert.match(await page.evaluate(() => window.copied), language === 'C#' ? /static void Main/ : /int main/);
    await page.close();
  });
