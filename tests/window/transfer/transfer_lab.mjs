// Transfer tab with a real sshd; run by tests/installer/transfer_test.sh.
import assert from 'node:assert/strict';
import {closeSync, openSync, readFileSync, readSync, writeFileSync} from 'node:fs';
import {after, before, test} from 'node:test';
import {smallPng} from '../small_png.mjs';
import {becomes, line, openTransfer} from './transfer_page.mjs';
import {kAxe, startBrowser, startWindow} from '../window_program.mjs';

const {LAB, PASSWORD, HOST_KEY} = process.env;
delete process.env.PASSWORD;  // the window inherits the environment
let browser, shown, page, other;

before(async () => {
  const robot = process.env.SHOTS ? ['--robot', 'twin'] : ['--robot', 'runtime', '--name', `${LAB}/nobody`];
  [browser, shown] = await Promise.all([startBrowser(), startWindow(...robot)]);
  [page, other] = [await openTransfer(browser, shown.url), await openTransfer(browser, shown.url)];
});
after(async () => {
  await browser?.close();
  await shown?.end();
});

test('asks for password and host key, then shows the robot\'s status', async () => {
  await page.fill('#robot-address', '127.0.0.1');
  await page.click('#transfer-status');
  await page.getByRole('dialog').getByText(HOST_KEY).waitFor();
  await page.getByRole('button', {name: 'Trust this key'}).click();
  await becomes(page, 'login needs a password');
  await page.locator('#robot-password:focus').fill(PASSWORD);
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');  // Connect
  await becomes(page, 'done');
  await line(page, 'output', 'version:    0.1.0+fake (confirmed)');
  await page.locator('#robot-used option', {hasText: 'darwin@127.0.0.1'}).waitFor({state: 'attached'});
});

test('sends and runs a controller, visible to all pages, with marked errors, until Cancel ends it', async () => {
  await page.fill('#controller-folder', `${LAB}/pc/walker`);
  await page.fill('#controller-arguments', '--speed 2');
  await page.click('#transfer-run');
  const seen = page.evaluate(() => new Promise((done) => {  // a step with progress
    const bar = document.querySelector('.transfer-progress .progress'), values = [];
    new MutationObserver(() => {
      values.push(Number(bar.ariaValueNow));
      if (document.querySelector('#transfer-state').textContent.includes('run on the robot')) done(values);
    }).observe(bar, {attributes: true});
  }));
  await Promise.all([line(page, 'output', 'walking --speed 2'), line(other, 'output', 'walking --speed 2')]);
  const values = await seen;
  assert.ok(values.every((value, i) => i === 0 || value >= values[i - 1]) && values.at(-1) >= 80, `${values}`);
  const error = page.locator('#transfer-console .error', {hasText: 'it wobbles'});
  await error.waitFor();
  assert.equal(await error.getByRole('img', {name: 'error'}).textContent(), '✖');
  const [red, green] = (await error.evaluate((node) => getComputedStyle(node).color)).match(/\d+/g).map(Number);
  assert.ok(red > 2 * green, 'errors are red');
  await page.waitForTimeout(process.env.SHOTS ? 1500 : 0);
  if (process.env.SHOTS) writeFileSync(`${process.env.SHOTS}/transfer.png`, await smallPng(page, await page.screenshot()));
  assert.equal(await other.locator('#transfer-send').isDisabled(), true, 'one thing at a time');
  await other.addScriptTag({path: kAxe});
  for (const colorScheme of ['light', 'dark']) {
    await other.emulateMedia({colorScheme});
    const {violations} = await other.evaluate(() => window.axe.run('#panes', {resultTypes: ['violations']}));
    assert.deepEqual(violations.map(({id, nodes}) => `${id}: ${nodes[0].html}`), [], colorScheme);
  }
  await other.click('#transfer-cancel');
  await line(page, 'output', 'kneeling');
  await becomes(page, 'cancelled');
});

test('makes it the default after a confirmation, and reports compiler errors', async () => {
  await page.click('#transfer-make-default');
  await page.getByRole('dialog').getByRole('button', {name: 'Make default'}).click();
  await becomes(page, 'done');
  await line(page, 'said', 'walker is the default controller now');
  await page.fill('#controller-folder', `${LAB}/pc/slip`);
  await page.click('#transfer-send');
  await becomes(page, 'slip does not compile');
  await line(page, 'error', 'main.cpp:');
  await line(page, 'warning', 'unused variable');
});

test('the password is neither in a page nor in the program\'s memory or output', async () => {
  for (const one of [page, other]) assert.ok(!(await one.content()).includes(PASSWORD));
  assert.ok(!(shown.said() + shown.printed()).includes(PASSWORD));
  const secret = Buffer.from(PASSWORD), memory = openSync(`/proc/${shown.process.pid}/mem`, 'r');
  let looked = 0;
  for (const row of readFileSync(`/proc/${shown.process.pid}/maps`, 'utf8').split('\n')) {
    const [, from, to] = row.match(/^(\w+)-(\w+) rw/) ?? [];
    if (!from) continue;
    const begin = Number.parseInt(from, 16), bytes = Buffer.alloc(Number.parseInt(to, 16) - begin);
    let count = 0;
    try { count = readSync(memory, bytes, 0, bytes.length, begin); } catch { continue; }
    looked += count;
    assert.equal(bytes.subarray(0, count).indexOf(secret), -1, row);
  }
  closeSync(memory);
  assert.ok(looked > 1e6);
});

test('killing the window stops the controller', async () => {
  await page.fill('#controller-folder', `${LAB}/pc/walker`);
  await page.fill('#controller-arguments', '--again 1');
  await page.click('#transfer-run');
  await line(page, 'output', 'walking --again 1');
  shown.process.kill('SIGKILL');
});
