// The programs on the pages: those in JavaScript print the same numbers as those in C++, near the true motion.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, scenes, solved } from './browser.mjs';

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'oddity-programs-'));
let browser;
before(async () => { browser = await launch(); });
after(() => { fs.rmSync(folder, { recursive: true }); return browser.close(); });

const file = (name, text) => { fs.writeFileSync(path.join(folder, name), text); return path.join(folder, name); };
const rows = (command, ...words) => execFileSync(command, words, { maxBuffer: 1e9, encoding: 'utf8' }).trim().split('\n');

function by_cpp(scene, code) {
  execFileSync('c++', ['-std=c++20', '-O1', '-ffp-contract=off', '-o', path.join(folder, scene), file(`${scene}.cpp`, code)]);
  return rows(path.join(folder, scene));
}

/// Errors in parts of a centimetre or a degree, at the judged times that are frames of the program. The true
/// motion is of tables, which share no code with programs.
function errorsInNeeds(scene, table) {
  const { unit, reference, norms, trajectory: { judged_at, observables } } = solved(scene), units = unit.split(', ');
  const groups = norms.length > 0 ? norms : observables.map((_, i) => [i]);
  return judged_at.flatMap((time, k) => {
    const row = table.find(([t]) => Math.abs(t - time) < 1e-9);
    if (!row) return [];
    const there = reference.slice(k * observables.length);
    return groups.map((components) => Math.hypot(...components.map((i) => row[1 + i] - there[i]))
      / ((units[components[0]] ?? unit) === 'm' ? 0.01 : Math.PI / 180));
  });
}

for (const scene of scenes.filter((name) => name !== 'bouncing_ball'))
  test(`${scene}: its program in JavaScript has the numbers of that in C++`, async (t) => {
    const { page, faults } = await open(browser, `${scene}.html`, { reduced: true });
    const printed = await page.$$eval('pre.code[data-language]', (all) => all.map((code) => [code.dataset.language, code.textContent]));
    const { 'C++': cpp, JavaScript: js, 'C#': cs } = Object.fromEntries(printed);
    const counted = await page.$$eval('.recipe summary', (all) => all.map((summary) => summary.textContent));
    const missing = await page.$$eval('.recipe .none', (all) => all.map((said) => said.textContent));
    await page.close();
    assert.deepEqual(faults, []);
    assert.ok(cpp, 'it has no C++');
    t.diagnostic(printed.map(([language, code]) => `${language} ${code.split('\n').length}`).join(', '));
    const own = counted.map((text) => text.match(/^(\d+) lines? of .* that do it/)).filter(Boolean).map(([, n]) => Number(n));
    assert.equal(own.length, printed.length);
    assert.ok(own.every((n) => n <= 60), `more than 60 lines: ${own}`);
    if (!js || !cs) assert.match(missing.join(' '), /there is no code in .* for this choice: /);
    if (!js) return;
    const [names, ...expected] = by_cpp(scene, cpp), [same, ...got] = rows('node', file(`${scene}.js`, js));
    assert.equal(same.replace(',qw,qx,qy,qz', ''), names.replace(',qw,qx,qy,qz', ''));
    assert.equal(got.length, expected.length);
    const columns = names.replace(',qw,qx,qy,qz', '').split(',').length;
    const numbers = (row) => row.split(',').slice(0, columns).map(Number);
    const size = Math.max(...expected.flatMap((row) => numbers(row).slice(1).map(Math.abs)));
    // Math.sin and the like differ from C's by a unit in the last place, 1e-16, which a motion may magnify.
    const roundings = 1e-9 * Math.max(size, 1);
    got.forEach((row, i) => numbers(row).forEach((x, k) => {
      const off = Math.abs(x - numbers(expected[i])[k]);
      assert.ok(off <= roundings, `row ${i}: ${row} and ${expected[i]}`);
    }));
    const errors = errorsInNeeds(scene, got.map(numbers));
    t.diagnostic(`errors in what a game allows: ${errors.map((x) => x.toPrecision(2)).join(', ')}`);
    assert.ok(errors.length > 0, 'no judged time is a frame');
    assert.ok(errors.every((x) => x <= 1), `errors in what a game allows: ${errors}`);
  });
