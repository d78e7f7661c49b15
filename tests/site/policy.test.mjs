// A page runs only the site's own files, whatever has got into its text.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { launch, site } from './browser.mjs';

let browser;
const planted = path.join(site, 'planted.html');
before(async () => { browser = await launch(); });
after(async () => {
  fs.rmSync(planted, { force: true });
  await browser.close();
});

test('scripts planted in a page do not run, and its own do', async () => {
  const text = fs.readFileSync(path.join(site, '3.5.html'), 'utf8');
  const bad = `<script>window.planted = 'script'</script><img src="data:,x" onerror="window.planted = 'handler'">`
    + `<script src="data:text/javascript,window.planted='data'"></script><style>body { --planted: style }</style>`
    + `<iframe srcdoc="<script>parent.planted = 'frame'</script>"></iframe><a id="bad" href="javascript:window.planted='link'">x</a>`
    + '<main id="main">';
  assert.ok(text.includes('<main id="main">'));
  fs.writeFileSync(planted, text.replace('<main id="main">', bad));
  const page = await browser.newPage();
  const refused = [];
  page.on('console', (message) => refused.push(message.text()));
  await page.goto(pathToFileURL(planted).href, { waitUntil: 'load' });
  await page.waitForFunction(() => window.oddity?.data && document.querySelector('.player-clock'));
  await page.$eval('#bad', (link) => link.click());
  await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 100)));
  const found = await page.evaluate(() => [window.planted ?? 'nothing', getComputedStyle(document.body).getPropertyValue('--planted')]);
  assert.deepEqual(found, ['nothing', '']);
  assert.ok(refused.filter((said) => /Content Security Policy/.test(said)).length >= 5, refused.join('\n'));
  await page.close();
});
