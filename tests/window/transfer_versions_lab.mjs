// Versions of the runtime through the Transfer tab, on a robot that has none: tests/installer/transfer_test.sh makes that robot
// and runs this in its lab.
import assert from 'node:assert/strict';
import {copyFileSync, existsSync, readlinkSync} from 'node:fs';
import {basename, join} from 'node:path';
import {after, before, test} from 'node:test';
import {becomes, line, openTransfer} from './transfer_page.mjs';
import {startBrowser, startWindow} from './window_program.mjs';

const {LAB, ROBOT, BUILT, NEXT} = process.env;
const kHome = join(ROBOT, 'opt/darwinop');
let browser, shown, page;

before(async () => {
  [browser, shown] = await Promise.all([startBrowser(), startWindow('--robot', 'runtime', '--name', `${LAB}/nobody`)]);
  page = await openTransfer(browser, shown.url);
  await page.fill('#robot-address', '127.0.0.1');
  await page.fill('#robot-user', 'robotis');
  await page.getByText('Key, port').click();
  await page.fill('#robot-key', `${LAB}/pc/key`);
});
after(async () => {
  await browser?.close();
  await shown?.end();
});

const current = () => readlinkSync(join(kHome, 'current'));

test('the newest build is installed, and a newer one over it', async () => {
  await page.click('#transfer-install');
  await becomes(page, /^Installing, robotis@127\.0\.0\.1: done\. version 0\.1\.0\+a is installed and confirmed$/);
  await line(page, 'output', 'doctor: everything is well');
  assert.equal(current(), 'versions/0.1.0+a');
  assert.equal(await page.locator('.transfer-progress .progress.good').getAttribute('aria-valuenow'), '100');
  copyFileSync(NEXT, join(BUILT, basename(NEXT)));
  await page.click('#transfer-install');
  await becomes(page, /: done\. version 0\.2\.0\+b is installed and confirmed$/);
  assert.equal(current(), 'versions/0.2.0+b');
});

test('it goes back by one version', async () => {
  await page.click('#transfer-rollback');
  await line(page, 'said', 'going back from 0.2.0+b to 0.1.0+a');
  await becomes(page, /^Going back, robotis@127\.0\.0\.1: done\. version 0\.1\.0\+a is installed and confirmed$/);
  assert.equal(current(), 'versions/0.1.0+a');
});

test('it is removed, after a question whose first answer is no', async () => {
  const question = page.getByRole('dialog', {name: 'Remove everything of darwinop from the robot?'});
  await page.click('#transfer-uninstall');
  await question.waitFor();
  await page.keyboard.press('Enter');
  await question.waitFor({state: 'detached'});
  await page.click('#transfer-status');  // one thing at a time: nothing else has begun
  await line(page, 'output', 'version:    0.1.0+a (confirmed)');
  await becomes(page, /^Connecting, .*: done/);
  await page.click('#transfer-uninstall');
  await question.getByRole('button', {name: 'Remove'}).click();
  await becomes(page, /^Removing, robotis@127\.0\.0\.1: done\. everything is removed/);
  assert.equal(existsSync(kHome), false);
});
