// The page for typing a problem's file, in a browser.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch, open, shoot, solved } from './browser.mjs';

const problems = fileURLToPath(new URL('../../chapters/examples/problems', import.meta.url));
const moves = (text) => /^\[model/m.test(text) && !/^\[tables/m.test(text);
const files = fs.readdirSync(problems).filter((name) => moves(fs.readFileSync(path.join(problems, name), 'utf8')));
const textOf = (name) => fs.readFileSync(path.join(problems, name), 'utf8');

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

/// Types a text, and waits until it has been read.
async function type(page, text) {
  await page.evaluate((typed) => {
    const area = document.querySelector('#own-file');
    const { read } = document.querySelector('.own').dataset;
    area.value = typed;
    area.dispatchEvent(new Event('input'));
    return new Promise((resolve) => {
      const look = () => (document.querySelector('.own').dataset.read === read ? setTimeout(look, 5) : resolve());
      look();
    });
  }, text);
}

const seen = (page) => page.evaluate(() => ({
  wrong: document.querySelector('.own-wrong').hidden ? '' : document.querySelector('.own-wrong').textContent,
  marked: !document.querySelector('.own-line').hidden,
  answer: document.querySelector('.own-answer').textContent,
  rows: document.querySelectorAll('.own .row').length,
  truth: document.querySelector('.player-truth')?.textContent ?? '',
  took: Number(document.querySelector('.own').dataset.took),
}));
const answered = (page) => page.waitForFunction(() => document.querySelector('.own').dataset.answered);

test('each example file is in the menu, moves, and is answered', async (t) => {
  const { page, faults } = await open(browser, 'own.html', { reduced: true });
  const titles = await page.$$eval('#own-example option', (options) => options.map((o) => o.textContent));
  assert.equal(titles.length, files.length);
  for (const [i, title] of titles.entries()) {
    await page.select('#own-example', String(i));
    await page.waitForFunction((n) => Number(document.querySelector('.own').dataset.read) > n, {}, i);
    await answered(page);
    const now = await seen(page);
    t.diagnostic(`${title}: ${now.took} ms. ${now.answer}`);
    assert.equal(now.wrong, '', title);
    assert.ok(now.rows >= 2, title);
    assert.match(now.answer, /is enough: at \d+ frames it is .* off at most, for \d+ evaluations|Nothing that the page has|No method is judged/, title);
    assert.match(now.truth, /taken for true/, title);
    const moved = await page.evaluate(() => {
      const { player } = document.querySelector('.own').oddity;
      const { observed } = player.motions.truth(player.parameters);
      return observed.every(Number.isFinite) && observed.some((x) => x !== observed[0]);
    });
    assert.ok(moved, title);
  }
  await shoot(page, 'own-answered');
  assert.deepEqual(faults, []);
  await page.close();
});

test('a long motion is judged by its first frames, at the rate of the file, and the page reports it', async () => {
  const { page } = await open(browser, 'own.html', { reduced: true });
  await type(page, textOf('quarter_car.toml').replace(/horizon = "[^"]*"/, 'horizon = "100 s"'));
  await answered(page);
  const { truth, answer } = await seen(page);
  assert.match(truth, /The page looks at the first 33\.3 s of 100 s\./);
  assert.match(answer, /at 2000 frames, the first 33\.3 s of 100 s, it is/);
  assert.ok(Math.abs(await page.$eval('.own', (place) => place.oddity.player.motions.frame) - 1 / 60) < 1e-12);
  await page.close();
});

test('its motions are those of the program', async () => {
  const { page } = await open(browser, 'own.html', { reduced: true });
  for (const [name, model, algorithm] of [['quarter_car.toml', 'body and wheel', 'Runge-Kutta 4'],
    ['double_pendulum.toml', null, 'Dormand-Prince 5(4)'], ['elastic_pendulum.toml', null, 'velocity Verlet'],
    ['gyroscope.toml', null, 'Runge-Kutta 4'], ['bouncing_ball.toml', null, 'Runge-Kutta 4'], ['rope.toml', null, 'symplectic Euler']]) {
    await type(page, textOf(name));
    const { trial, times } = programs(name, model, algorithm);
    const mine = await page.evaluate((asked) => {
      const { player } = document.querySelector('.own').oddity;
      return [...window.oddity.engine.run({ scene: 'own', parameters: player.parameters, precision: 'double', ...asked }).observed];
    }, { model: trial.model, algorithm, setting: trial.knob, times: [0, ...times] });
    const theirs = trial.value;
    const size = Math.max(...theirs.map(Math.abs));
    const after = mine.slice(mine.length - theirs.length);
    theirs.forEach((x, i) => assert.ok(Math.abs(after[i] - x) <= 1e-9 * size, `${name}, ${algorithm}: ${after[i]} is not ${x}`));
  }
  await page.close();
});

/// The program's own finest trial that got to the end, and the times of its values.
function programs(name, model, algorithm) {
  const { trials, trajectory } = solved(path.join(problems, name));
  const trial = trials.filter((one) => one.algorithm === algorithm && (!model || one.model === model)
    && one.precision === 'double' && one.outcome === 'ok').at(-1);
  return { trial, times: trajectory.judged_at };
}

test('it answers a key within a tenth of a second', async (t) => {
  const { page } = await open(browser, 'own.html', { reduced: true });
  for (const name of files) {
    const text = textOf(name);
    await type(page, text);
    const took = [];
    for (let i = 0; i < 3; i += 1) {
      await type(page, text + ' '.repeat(i + 1));
      took.push((await seen(page)).took);
    }
    const least = Math.min(...took);
    t.diagnostic(`${name}: ${least} ms`);
    assert.ok(least <= 100 * Number(process.env.SLOW ?? 3), `${name}: ${took} ms`);  // a machine may be busy
  }
  await page.close();
});

test('an error is shown with its line and a caret, and the page stays as it was', async () => {
  const { page, faults } = await open(browser, 'own.html', { reduced: true });
  const good = textOf('quarter_car.toml');
  await type(page, good);
  for (const [from, to, line, reason] of [
    ['m y\'\' = -k (y - x)', 'm y\'\' = -q (y - x)', 'm y', /no letter q/],
    ['"300 kg, 50 to 2000"', '"300 parsnips, 50 to 2000"', 'parsnips', /no unit 'parsnips'/],
    ['w x\'\' = k (y - x)', 'w x\'\' = 2 s + k (y - x)', 'w x', /do not add up/],
    ['[observe]', '[observe', '[observe', /.+/],
    ['title =', 'tilte =', 'tilte', /no key tilte; did you mean 'title'/],
  ]) {
    assert.ok(good.includes(from), from);
    const text = good.replace(from, to);
    await type(page, text);
    const { wrong, marked } = await seen(page);
    const [, number] = /^this file:(\d+):\d+: /.exec(wrong) ?? [];
    assert.ok(text.split('\n')[number - 1].includes(line), `${wrong} is at another line than ${line}`);
    assert.match(wrong, reason);
    assert.match(wrong, /\n +\^$/);
    assert.ok(marked || number > 20);
    assert.equal(await page.$eval('#own-file', (area) => area.getAttribute('aria-invalid')), 'true');
    assert.ok(await page.$eval('.own .player', (player) => player.classList.contains('stale')));
  }
  await type(page, good);
  assert.equal((await seen(page)).wrong, '');
  assert.equal(await page.$eval('.own .player', (player) => player.classList.contains('stale')), false);
  assert.deepEqual(faults, []);
  await page.close();
});

test('hostile texts end in a sentence, and run nothing', async (t) => {
  const { page, faults } = await open(browser, 'own.html', { reduced: true });
  const good = textOf('quarter_car.toml');
  const tags = '<img src=x onerror=\'window.planted=1\'><script>window.planted=1</script>';
  const formula = (text) => good.replace('w x\'\' = k (y - x)', `w x'' = ${text} k (y - x)`);
  const texts = {
    'a million parentheses': '('.repeat(1e6),
    'parentheses in a formula': formula('('.repeat(15000)),
    'parentheses within the limits': formula('('.repeat(5000) + '1' + ')'.repeat(5000)),
    'calls within calls': formula('abs('.repeat(3000)),
    'brackets': 'a = ' + '['.repeat(90000),
    'tables': 'a = ' + '{a='.repeat(20000),
    'dots': 'a' + '.a'.repeat(40000) + ' = 1',
    'signs': formula('-'.repeat(10000)),
    'powers': formula('1^'.repeat(5000) + '1'),
    'roots': formula('sqrt('.repeat(3000) + '1' + ')'.repeat(3000)),
    'a very long file': good + '# '.repeat(1e6),
    'NUL': good.replace('title', 'title\0'),
    'control characters': `title = "\u0001\u0002\u001b[31m"`,
    'a script for a title': good.replace('"Quarter car over a bump"', `"${tags}"`),
    'a script for a letter': good.replace('says = "the spring"', `says = "${tags}"`),
    'a script for a model': good.replace('[model."body alone"]', `[model."${tags}"]`),
    'a script for a unit': good.replace('300 kg', '300 <script>window.planted=1</script>'),
    'a script in an error': tags,
    'huge numbers': good.replace('300 kg, 50 to 2000', '1e308 kg'),
    'numbers beyond': good.replace('300 kg, 50 to 2000', '1e999999 kg'),
    'tiny numbers': good.replace('300 kg, 50 to 2000', '1e-300 kg'),
    'a zero mass': good.replace('300 kg, 50 to 2000', '0 kg'),
    'an endless horizon': good.replace('horizon = "10 s"', 'horizon = "1e9 s"'),
    'a frame rate without bounds': good.replace('fps = 60', 'fps = 1e300'),
    'another script\'s letters': good.replace('the spring', '\u202e\u0627\u0644\ud83d\ude00\u0301\u0301'),
    'half a letter': good.replace('the spring', '\ud800'),
    ['__proto__']: good.replaceAll('\nh = ', '\n__proto__ = ').replace('h sin', '__proto__ sin'),
    'constructor': good.replaceAll('\nh = ', '\nconstructor = ').replace('h sin', 'constructor sin'),
    'toString': good.replaceAll('\nh = ', '\ntoString = ').replace('h sin', 'toString sin'),
    'an event without end': textOf('bouncing_ball.toml').replace(/horizon = ".*"/, 'horizon = "1000 s"'),
    'a stiff spring': good.replace('30 kN/m, 1 to 100', '1e15 kN/m'),
  };
  for (const [name, text] of Object.entries(texts)) {
    const began = Date.now();
    await type(page, text);
    const took = Date.now() - began;
    t.diagnostic(`${name}: ${took} ms, ${(await seen(page)).wrong.slice(0, 80).replace(/\n/g, ' ')}`);
    assert.ok(took < 5000 * Number(process.env.SLOW ?? 3), `${name} takes ${took} ms`);
    assert.equal(await page.evaluate(() => window.planted ?? 'nothing'), 'nothing', name);
    assert.equal(await page.$$eval('.own img, .own script', (all) => all.length), 0, name);
  }
  await type(page, good);
  assert.equal((await seen(page)).wrong, '');
  await answered(page);
  assert.deepEqual(faults, []);
  await page.close();
});

test('a link brings back the file, its methods and a parameter', async () => {
  const { page } = await open(browser, 'own.html', { reduced: true });
  const text = textOf('elastic_pendulum.toml').replace('title = "', 'title = "My \u00e9 \ud83d\ude00 ');
  await type(page, text);
  await page.$$eval('.own .player-actions button', (all) => all.find((b) => b.textContent === 'break it').click());
  const setting = await page.evaluate(() => document.querySelector('.own').oddity.player.rows[0].method.setting);
  await page.$$eval('.own .player-actions button', (all) => all.find((b) => b.textContent === 'copy link').click());
  await page.waitForFunction(() => window.location.hash.startsWith('#file='));
  const hash = await page.evaluate(() => window.location.hash);
  const again = await open(browser, `own.html${hash}`, { reduced: true });
  assert.equal(await again.page.$eval('#own-file', (area) => area.value), text);
  assert.equal(await again.page.evaluate(() => document.querySelector('.own').oddity.player.rows[0].method.setting), setting);
  assert.deepEqual(again.faults, []);
  await again.page.close();
  await page.close();
});

test('a damaged link is refused in a sentence', async () => {
  for (const hash of ['file=', 'file=z.', 'file=z.AAAA', 'file=z.%%%', 'file=q.abc', 'file=t.%E0%A4%A', 'file=z.' + 'A'.repeat(300000), 'file=t.' + 'a'.repeat(150000)]) {
    const { page, faults } = await open(browser, `own.html#${hash}`, { reduced: true });
    const { wrong } = await seen(page);
    assert.match(await page.$eval('.own-says', (says) => says.textContent), /^The link .*This is the page as it opens\.$/, hash.slice(0, 20));
    assert.equal(wrong, '');
    assert.deepEqual(faults, []);
    await page.close();
  }
});

test('\u201cbreak it\u201d finds a step with which a method fails', async () => {
  const { page } = await open(browser, 'own.html', { reduced: true });
  await type(page, textOf('rope.toml'));
  await page.$$eval('.own .player-actions button', (all) => all.find((b) => b.textContent === 'break it').click());
  assert.match(await page.$eval('.own .player-says', (says) => says.textContent), /at a step of/);
  assert.ok(await page.$eval('.own .row-ending', (ending) => ending.classList.contains('row-fails')));
  await page.close();
});

test('a model is printed as C++', async () => {
  const { page } = await open(browser, 'own.html', { reduced: true });
  await type(page, textOf('quarter_car.toml'));
  const code = await page.$eval('.own-code', (pre) => pre.textContent);
  assert.match(code, /struct BodyAndWheel \{/);
  assert.match(code, /std::array<double, 4>/);
  await type(page, textOf('bouncing_ball.toml'));
  assert.match(await page.$eval('.own-code', (pre) => pre.textContent), /^This model has no code to print/);
  await page.close();
});
