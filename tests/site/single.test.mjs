// One page as one file, as it is mailed: alone in a folder, it plays and requests nothing.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { isWhole, launch, program } from './browser.mjs';

let browser;
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'single-'));
before(async () => { browser = await launch(); });
after(async () => {
  fs.rmSync(folder, { recursive: true });
  await browser.close();
});

for (const exercise of ['3.5', '3.33', '2.9'])
  test(`${exercise} as one file is whole`, async () => {
    const file = path.join(folder, `${exercise}.html`);
    execFileSync(program, ['site', '--single', exercise, '--out', file]);
    assert.ok(fs.statSync(file).size <= 1e6, `${fs.statSync(file).size} bytes`);
    const page = await browser.newPage();
    page.setDefaultTimeout(0);
    const faults = [];
    page.on('console', (message) => faults.push(message.text()));
    page.on('pageerror', (error) => faults.push(error.message));
    page.on('request', (request) => { if (!/^(file|data|blob):/.test(request.url())) faults.push(request.url()); });
    page.on('requestfailed', (request) => faults.push(request.url()));
    await page.goto(pathToFileURL(file).href, { waitUntil: 'load' });
    await page.waitForFunction(isWhole);
    if (await page.$('.player-clock')) {
      await page.$eval('.player', (player) => player.scrollIntoView({ block: 'center' }));
      await page.waitForFunction(() => parseFloat(document.querySelector('.player-clock').textContent.replace(/^t = /, '')) > 0);
    }
    const elsewhere = await page.$$eval('a[href]', (all) => all.map((a) => a.getAttribute('href')).filter((to) => !/^(#|http)/.test(to)));
    assert.deepEqual(elsewhere, []);
    assert.deepEqual(faults, []);
    await page.close();
  });
