// A site in a headless browser: what the tests of pages, players and charts share.
//   SITE=FOLDER   the site (default: build/site)
//   SHOTS=FOLDER  where pictures of the pages go; none without it
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import puppeteer from 'puppeteer-core';

const here = path.dirname(fileURLToPath(import.meta.url));
export const site = path.resolve(process.env.SITE ?? path.join(here, '../../build/site'));
export const pages = fs.readdirSync(site).filter((name) => name.endsWith('.html')).sort();
export const scenes = fs.readdirSync(path.join(site, 'data'))
  .filter((name) => /^\d+\.\d+\.js$/.test(name) && !fs.readFileSync(path.join(site, 'data', name), 'utf8').includes('"scene":null'))
  .map((name) => name.replace(/\.js$/, ''));

export const launch = () => puppeteer.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--allow-file-access-from-files=false', '--disable-gpu'],
});

/// Opens a page; `faults` grows by whatever it says on the console, throws, or asks of anything beside the site.
export async function open(browser, name, { width = 1200, height = 900, dark = false, reduced = false } = {}) {
  const page = await browser.newPage();
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
  return { page, faults };
}

/// A picture of the whole page, where pictures are asked for.
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
