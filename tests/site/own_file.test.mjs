// The parts of the page for typing a problem's file that need no browser. Run: node --test tests/site/own_file.test.mjs
//   SITE=FOLDER   the site, for its reader of files (default: build/site)
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { createContext, runInContext } from 'node:vm';

const tree = fileURLToPath(new URL('../..', import.meta.url));
const site = path.resolve(process.env.SITE ?? path.join(tree, 'build/site'));
const context = createContext({
  atob, btoa, performance, Blob, Response, CompressionStream, DecompressionStream, TextDecoder, TextEncoder, WebAssembly
});
context.window = context;
const load = (file) => runInContext(readFileSync(file, 'utf8'), context);
for (const name of ['engine.js', 'file_link.js', 'own_table.js']) load(path.join(tree, 'report/site/assets', name));
const { oddity } = context;
oddity.takenNames = ['t', 'sin'];
before(async () => {
  load(path.join(site, 'assets/own.js'));
  assert.ok(await oddity.engine.ready);
});

const text = `title = "x"
[parameters]
m = "2 kg"
k = { value = "30 N/m", says = "the spring" }
[model.one]
equations = ["m y'' = -k y"]
start = { y = "1 m", "y'" = 0 }
[observe]
y = "m"
`;
const wrong = async (file) => (await oddity.engine.take(file)).wrong?.message.split('\n')[0] ?? '';

test('a file may be longer than a link', async () => {
  const long = text + '# \u00e4\n'.repeat(40000);
  assert.equal(await wrong(long), '');
  assert.equal(await oddity.fileLink.format(long, '#play'), null);
  const short = await oddity.fileLink.format(text, '#play&row=1');
  assert.deepEqual({ ...await oddity.fileLink.parse(short) }, { text, play: '#play&row=1' });
  assert.match(await wrong(text + '#'.repeat(1e6)), /has at most a megabyte/);
});

test('a link that could not be read again is not written', async () => {
  let noise = '';
  for (let i = 0, x = 1; i < 99000; i += 1) noise += String.fromCharCode(0x4e00 + (x = (x * 48271) % 2147483647) % 20000);
  assert.equal(await oddity.fileLink.format(noise, '#play'), null);
});

test('a table has a name that formulas can call, and that is not taken', () => {
  for (const [file, name] of [['2 my bump (3).csv', 'my_bump_3'], ['sin.csv', 'sin_2'], ['t.txt', 't_2'], ['m.csv', 'm_2'], ['12.csv', 'rows']])
    assert.equal(oddity.nameOfTable(file, text), name);
  const once = oddity.withTable(text, 'bump', '0,0\n1,1\n2,0\n');
  assert.equal(oddity.nameOfTable('bump.csv', once), 'bump_2');
});

test('a table that is opened twice is a part of the file twice, whatever ends its lines', async () => {
  for (const end of ['\n', '\r\n', '\r']) {
    const rows = ['t,F', '(s),(N)', '0,0', '"1";"\\0.5"', '', '2\t0', 'end of data'].join(end);
    let file = text;
    for (let i = 0; i < 2; i += 1) file = oddity.withTable(file, oddity.nameOfTable('bump.csv', file), rows);
    assert.equal(file.match(/rows = """\n0,0\n1;0.5\n2\t0\n"""/g).length, 2);
    assert.equal(await wrong(file), '');
  }
});

test('NaN in a table is refused, and not left out', async () => {
  assert.equal(await wrong(oddity.withTable(text, 'bump', 'nan,5\n0,0\n1,1\n2,0\n')), 'this file:16:1: expected two numbers, as 0.1, 5');
});

test('a staging that engines could not take is refused', async () => {
  const staged = `${text}[staged]\nobserve = { y = "bob_x" }\n[[staged.body]]\nname = "bob"\nmass = "0 kg"\ninertia = "1 kg m^2"\n`;
  assert.match(await wrong(staged), /^this file:14:9: engines take bodies of a mass/);
});

test('a text at the end of a comment does not change its program', async () => {
  for (const end of ['\\\\', '\\\\ ', '\\r int i;', '\\n int i;']) {
    const { file } = await oddity.engine.take(text.replace('the spring', `the spring ${end}`).replace('title = "x', `title = "x${end}`));
    const code = oddity.engine.code(0, { m: 2, k: 30 });
    const lines = code.split('\n').filter((line) => line.startsWith('//') || line.includes('// '));
    assert.ok(lines.length >= 3 && lines.every((line) => !/[\\\r]\s*$|\r/.test(line)), code);
    assert.equal(code.includes('\n int i;'), false);
    assert.equal(file.parameters.length, 2);
  }
});
