// A remote robot: runtime, monitor and remote server, and a window that uses only their ports.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {message} from './messages.mjs';
import {startBrowser, startProgram, startWindow} from './window_program.mjs';

let browser, robot, monitor, server, shown, page;
let name;

const portOf = (program) => program.printed().match(/127\.0\.0\.1:(\d+)/)[1];
const startMonitor = (port) => startProgram('monitor', ['--port', port], /ready: ws:.*\n/, {DARWINOP_RUNTIME_NAME: name});

before(async () => {
  [browser, robot] = await Promise.all([startBrowser(), startWindow('--robot', 'virtual')]);
  [, name] = robot.printed().match(/DARWINOP_RUNTIME_NAME=(\S+)/);
  [monitor, server] = await Promise.all([startMonitor('0'),
    startProgram('remote', ['--port', '0'], /\d\n/, {DARWINOP_RUNTIME_NAME: name})]);
  shown = await startWindow('--robot', `tcp://127.0.0.1:${portOf(server)}`, '--monitor', `127.0.0.1:${portOf(monitor)}`);
  page = await browser.newPage();
  await page.goto(shown.url);
  await page.waitForFunction(() => window.darwinop?.view && window.darwinop.timeline.live?.count > 30);
});
after(async () => {
  await browser?.close();
  for (const program of [shown, server, monitor, robot]) await program?.end();
});

const stateIs = (state) => page.waitForFunction((wanted) =>
  document.getElementById('pills').textContent.includes(`State${wanted}`), state);

test('observes and drives the robot over the network', async () => {
  const short = {timeout: 4000};
  await page.click('#tab-3');
  // On a busy computer the page may lose the session: try again.
  for (let tries = 1; ; ++tries) {
    try {
      await page.click('#take', short);
      await page.locator('body.driving').waitFor(short);
      await stateIs('driven');
      await page.locator('#aim-Neck').fill('30', short);
      await page.waitForFunction(() => {
        const {live} = window.darwinop.timeline;
        return live.at(live.index.get('Neck.position'), live.count - 1) > 0.4;
      }, null, short);
      await page.click('#stop', short);
      break;
    } catch (error) {
      if (tries === 4) throw error;
      await page.evaluate(() => window.darwinop.steering.stop());
    }
  }
  await page.locator('body:not(.driving)').waitFor();
  await stateIs('holding');
});

test('the doctor of a robot on another computer is run there', async () => {
  await page.click('#tab-0');
  assert.equal(await page.locator('#doctor-check').isDisabled(), true);
  assert.ok((await page.locator('.doctor code').innerText()).includes(message('kDoctorThere')));
});

test('reports a monitor that ends and reconnects when it is back', async () => {
  const port = portOf(monitor);
  await monitor.end();
  const banner = page.locator('#banner').filter({hasText: message('kNoMonitor').trim()});
  await banner.waitFor();
  monitor = await startMonitor(port);
  await page.locator('#banner').waitFor({state: 'hidden'});
});
