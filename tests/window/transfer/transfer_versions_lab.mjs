// Installing runtime versions with the Transfer tab on a robot without one; run by tests/installer/transfer_test.sh.
import assert from 'node:assert/strict';
import {copyFileSync, existsSync, readlinkSync} from 'node:fs';
import {basename, join} from 'node:path';
import {after, before, test} from 'node:test';
import {becomes, line, openTransfer} from './transfer_page.mjs';
import {startBrowser, startWindow} from '../window_program.mjs';

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

test('installs the newest build and updates it', async () => {
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

test('goes back by one version', async () => {
  await page.click('#transfer-rollback');
  await line(page, 'said', 'returning from 0.2.0+b to 0.1.0+a');
  await becomes(page, /^Going back, robotis@127\.0\.0\.1: done\. version 0\.1\.0\+a is installed and confirmed$/);
  assert.equal(current(), 'versions/0.1.0+a');
});

test('removes it after a confirmation, not after Cancel', async () => {
  const question = page.getByRole('dialog', {name: 'Remove everything of darwinop from the robot?'});
  await page.click('#transfer-uninstall');
  await question.waitFor();
  await page.keyboard.press('Enter');
  await question.waitFor({state: 'detached'});
  await page.click('#transfer-status');  // only one run at a time: none has started
  await line(page, 'output', 'version:    0.1.0+a (confirmed)');
  await becomes(page, /^Connecting, .*: done/);
  await page.click('#transfer-uninstall');
  await question.getByRole('button', {name: 'Remove'}).click();
  await becomes(page, /^Removing, robotis@127\.0\.0\.1: done\./);
  assert.equal(existsSync(kHome), false);
});
