// A site in a headless browser, for the tests of pages, players and charts.
//   SITE=FOLDER   the site (default: build/site)
//   ODDITY=FILE   the program that players are compared with (default: build/release/oddity)
//   SHOTS=FOLDER  for pictures of the pages; none without it
import fs from 'node:fs';
import path from 'node:path';
import { execFileSync } from 'node:child_process';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { gunzipSync } from 'node:zlib';
import puppeteer from 'puppeteer-core';

const here = path.dirname(fileURLToPath(import.meta.url));
export const site = path.resolve(process.env.SITE ?? path.join(here, '../../build/site'));
export const program = path.resolve(process.env.ODDITY ?? path.join(here, '../../build/release/oddity'));
export const pages = fs.readdirSync(site).filter((name) => name.endsWith('.html')).sort();
export const scenes = fs.readdirSync(path.join(site, 'data'))
  .filter((name) => /^(\d+\.\d+|bouncing_ball)\.js$/.test(name) && unpacked(path.join(site, 'data', name)).scene)
  .map((name) => name.replace(/\.js$/, ''));

/// The data that a file of data/ gives to the page.
function unpacked(file) {
  const [, packed] = fs.readFileSync(file, 'utf8').match(/^oddity\.\w+\("([A-Za-z0-9+/=]*)"\);\n$/);
  return JSON.parse(gunzipSync(Buffer.from(packed, 'base64')));
}

/// The quantity of a scene's motion as the program computes it at parameters like "a=0.7".
export function solved(scene, ...parameters) {
  const json = execFileSync(program, ['solve', scene, ...parameters, '--json'], { maxBuffer: 1e9 });
  return JSON.parse(json).exercises[0].quantities.find((q) => q.trajectory);
}

export const launch = () => puppeteer.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  protocolTimeout: 0,  // a machine may be busy
  args: ['--no-sandbox', '--allow-file-access-from-files=false', '--disable-gpu'],
});

/// Whether the page has its data and its players.
export function isWhole() {
  const given = [...document.scripts].some((script) =>
    (script.src.includes('/data/') && !script.src.endsWith('/search.js')) || script.text.startsWith('\noddity.exercise('));
  const own = document.querySelector('.own');
  return (!given || window.oddity.data || window.oddity.allScenes || own) && !(own && !own.dataset.ready)
    && !(window.oddity.data?.scene && document.querySelector('.player:not(:has(.player-clock))'));
}

/// Opens a page. `faults` collects console messages, exceptions, and requests outside the site.
export async function open(browser, name, { width = 1200, height = 900, dark = false, reduced = false, scripts = true } = {}) {
  const page = await browser.newPage();
  page.setDefaultTimeout(0);
  await page.setJavaScriptEnabled(scripts);
  const faults = [];
  page.on('console', (message) => faults.push(`console: ${message.text()}`));
  page.on('pageerror', (error) => faults.push(`error: ${error.message}`));
  page.on('request', (request) => {
    const url = request.url();
    const ours = url.startsWith(pathToFileURL(site).href) || url.startsWith('data:') || url.startsWith('blob:');
    if (!ours) faults.push(`request: ${url}`);
  });
  page.on('requestfailed', (request) => faults.push(`not there: ${request.url()}`));
  await page.setViewport({ width, height });
  await page.emulateMediaFeatures([
    { name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' },
    { name: 'prefers-reduced-motion', value: reduced ? 'reduce' : 'no-preference' },
  ]);
  const [file, hash] = name.split('#');
  await page.goto(pathToFileURL(path.join(site, file)).href + (hash ? `#${hash}` : ''), { waitUntil: 'load' });
  if (scripts) await page.waitForFunction(isWhole);
  return { page, faults };
}

/// Pairs of texts in <main> that overlap, each text as far as it is visible, except those within `except`.
export function overlaps(page, except = '.none-such') {
  return page.evaluate((left_out) => {
    const seen = [];
    // Parts that an element cuts off or scrolls are invisible.
    const within = (box, place) => {
      let { left, right, top, bottom } = box;
      for (let around = place; around; around = around.parentElement) {
        if (around instanceof SVGElement || around.closest('math') || getComputedStyle(around).overflow === 'visible') continue;
        const cut = around.getBoundingClientRect();
        [left, right, top, bottom] = [Math.max(left, cut.left), Math.min(right, cut.right), Math.max(top, cut.top), Math.min(bottom, cut.bottom)];
      }
      return { left, right, top, bottom };
    };
    const walker = document.createTreeWalker(document.querySelector('main'), NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
      const { parentElement: place, data } = walker.currentNode;
      if (!data.trim() || place.closest(`.unseen, caption, noscript, option, ${left_out}`) || !place.checkVisibility({ checkVisibilityCSS: true })) continue;
      const range = document.createRange();
      range.selectNodeContents(walker.currentNode);
      const whole = place.closest('math') ?? walker.currentNode;
      for (const box of range.getClientRects()) {
        const { left, right, top, bottom } = within(box, place);
        if (left >= right || top >= bottom) continue;
        const quarter = (bottom - top) / 4;  // letters do not fill the height of their line
        seen.push({ whole, text: data.trim(), left: left + 1, right: right - 1, top: top + quarter, bottom: bottom - quarter });
      }
    }
    const meet = (a, b) => a.whole !== b.whole && a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
    seen.sort((a, b) => a.top - b.top);
    const found = new Set();
    seen.forEach((a, i) => {
      for (let k = i + 1; k < seen.length && seen[k].top < a.bottom; k += 1)
        if (meet(a, seen[k])) found.add(`\u201c${a.text}\u201d and \u201c${seen[k].text}\u201d`);
    });
    return [...found];
  }, except);
}

/// A picture of the whole page, if pictures are requested.
export async function shoot(page, name) {
  if (!process.env.SHOTS) return;
  fs.mkdirSync(process.env.SHOTS, { recursive: true });
  await page.screenshot({ path: path.join(process.env.SHOTS, `${name}.png`), fullPage: true });
}

export function bytes(folder) {
  return fs.readdirSync(folder, { withFileTypes: true })
    .reduce((sum, entry) => sum + (entry.isDirectory()
      ? bytes(path.join(folder, entry.name))
      : fs.statSync(path.join(folder, entry.name)).size), 0);
}
