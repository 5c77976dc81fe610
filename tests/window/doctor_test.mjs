// The doctor on the first tab: a virtual robot with a broken chain, and a port that another program uses.
import assert from 'node:assert/strict';
import {spawn, spawnSync} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {startBrowser, startProgram} from './window_program.mjs';

const folder = mkdtempSync(join(tmpdir(), 'darwinop-doctor-'));
const port = join(folder, 'robot');
const kRobot = {DARWINOP_ROBOT: port, DARWINOP_ROBOT_FILE: '/dev/null'};
let browser, robot, shown, page;

before(async () => {
  [browser, robot] = await Promise.all([startBrowser(),
    startProgram('virtual-robot', ['--link', port, '--servo', 'AnkleR=missing', '--servo', 'FootR=missing'], /\n/)]);
  // No runtime of this name runs.
  shown = await startProgram('window', ['--robot', 'runtime', '--name', join(folder, 'runtime')], /http:\S+\n/, kRobot);
  page = await browser.newPage();
  await page.goto(shown.printed().match(/http:\S+/)[0]);
});
after(async () => {
  await browser?.close();
  await shown?.end();
  await robot?.end();
  rmSync(folder, {recursive: true});
});

const doctor = () => page.locator('.doctor');
const printed = () => JSON.parse(spawnSync(`${process.env.DARWINOP_BIN}/darwinop-doctor`, ['--json'],
  {env: {...process.env, ...kRobot}, encoding: 'utf8'}).stdout);

async function check() {
  await page.click('#doctor-check');
  await page.locator('#doctor-check:disabled').waitFor();
  await page.locator('#doctor-check:enabled').waitFor({timeout: 120000});
}

test('shows fault, evidence and remedy of a broken chain as the command prints them, without a runtime', async () => {
  assert.equal(await doctor().locator('details').first().isVisible(), false);
  await check();
  const document = printed(), fault = document.faults.find(({name}) => name === 'chain_broken');
  const row = doctor().locator('.fault').filter({hasText: fault.what}).first();
  for (const text of [fault.what, fault.remedy]) assert.ok((await row.innerText()).includes(text), text);
  assert.equal(await doctor().locator('summary').first().innerText(), document.summary);
});

test('runs again, and says which program uses the port instead of judging the robot', async () => {
  const holder = spawn('flock', [port, 'sleep', '100'], {detached: true});
  try {
    await doctor().locator('.fault').first().waitFor();
    for (let tries = 0; printed().examined; ++tries) assert.ok(tries < 20, 'flock has not opened the port');
    await check();
    const {faults: [{name, what, remedy}], summary} = printed();
    assert.equal(name, 'other_program');
    const row = doctor().locator('.fault').filter({hasText: what}).first();
    assert.ok((await row.innerText()).includes(remedy.replaceAll('`', '')));
    assert.equal(await row.locator('code').innerText(), `sudo fuser -v ${port}`);
    assert.equal(await doctor().locator('summary').first().innerText(), summary);
    assert.match(await doctor().innerText(), new RegExp(`process ${holder.pid} `));
  } finally {
    process.kill(-holder.pid);
  }
});
