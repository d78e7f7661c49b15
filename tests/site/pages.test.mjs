// Every page of the site, opened from its file.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { bytes, launch, open, overlaps, pages, scenes, shoot, site } from './browser.mjs';

const axe = fs.readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

test('the site is one folder of at most 6 MB', () => {
  assert.ok(bytes(site) <= 6e6, `${site} has ${bytes(site)} bytes`);
});

test('the front page, with all files that it loads at once, is at most 300 KB', () => {
  const text = fs.readFileSync(`${site}/index.html`, 'utf8');
  const files = [...text.matchAll(/(?:src|href)="((?:assets|data)\/[^"]+)"/g)].map(([, file]) => file);
  assert.ok(files.length >= 3);
  const size = [...files, 'index.html'].reduce((sum, file) => sum + fs.statSync(`${site}/${file}`).size, 0);
  assert.ok(size <= 300e3, `it has ${size} bytes`);
});

for (const name of pages) {
  for (const dark of [false, true]) {
    test(`${name}, ${dark ? 'dark' : 'light'}: nothing asked for, nothing said, accessible`, async () => {
      const { page, faults } = await open(browser, name, { dark, reduced: true });
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ['violations'] }));
      assert.deepEqual(violations.map((v) => `${v.id}: ${v.nodes[0].html.slice(0, 200)}`), []);
      await shoot(page, `${name}-${dark ? 'dark' : 'light'}`);
      assert.deepEqual(faults, []);
      await page.close();
    });
  }
  test(`${name}, 390 px wide: nothing is cut off`, async () => {
    const { page, faults } = await open(browser, name, { width: 390, height: 844, reduced: true });
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    await shoot(page, `${name}-390`);
    assert.ok(width <= 390, `the page is ${width} px wide`);
    assert.deepEqual(faults, []);
    await page.close();
  });
}

for (const name of pages)
  test(`${name}: no two texts overlap, at any width, in dark, and on A4`, async () => {
    const { page, faults } = await open(browser, name, { reduced: true });
    for (const width of [390, 768, 1280, 688])
      for (const media of width === 688 ? ['print'] : ['light', 'dark']) {
        await page.setViewport({ width, height: 900 });
        await page.emulateMediaType(media === 'print' ? 'print' : 'screen');
        await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: media === 'dark' ? 'dark' : 'light' }]);
        await page.evaluate(() => new Promise((done) => { setTimeout(() => requestAnimationFrame(done), 300); }));
        assert.deepEqual(await overlaps(page, media === 'print' ? '.chart' : undefined), [], `${width} px, ${media}`);  // charts stay as the screen has them
      }
    assert.deepEqual(faults, []);
    await page.close();
  });

test('how soon pages paint', async (t) => {
  for (const name of ['index.html', ...scenes.map((scene) => `${scene}.html`)]) {
    const { page } = await open(browser, name);
    const first = await page.waitForFunction(() => performance.getEntriesByName('first-contentful-paint')[0]?.startTime)
      .then((handle) => handle.jsonValue());
    t.diagnostic(`${name}: first paint after ${Math.round(first)} ms`);
    await page.close();
  }
});

test('every link leads somewhere', async () => {
  const ids = new Map();
  const links = [];
  for (const name of pages) {
    const { page } = await open(browser, name, { reduced: true });
    ids.set(name, new Set(await page.evaluate(() => [...document.querySelectorAll('[id]')].map((e) => e.id))));
    links.push(...(await page.evaluate(() => [...document.querySelectorAll('a[href]')].map((a) => a.getAttribute('href'))))
      .map((href) => ({ name, href })));
    await page.close();
  }
  const broken = links.filter(({ name, href }) => {
    if (/^[a-z]+:/.test(href)) return !/^(https:\/\/|data:)/.test(href);
    const [file, id] = decodeURIComponent(href).split('#');
    if (file && !file.endsWith('.html')) return !fs.existsSync(`${site}/${file}`);
    const target = ids.get(file || name);
    return !target || (id && !id.includes('=') && !target.has(id));
  });
  assert.deepEqual(broken, []);
});
