// Tabs, time bar, and initial values of the Transfer tab.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {startBrowser, startWindow} from './window_program.mjs';

const kWithCurves = ['Servos', 'All curves', 'Motion sensors'];
let browser, shown;

before(async () => {
  [browser, shown] = await Promise.all([startBrowser(), startWindow('--robot', 'virtual')]);
});
after(async () => {
  await browser?.close();
  await shown?.end();
});

async function openPage() {
  const page = await browser.newPage();
  await page.goto(shown.url);
  await page.waitForFunction(() => window.darwinop?.timeline.live?.count > 30);
  return page;
}

test('tabs are one row on any screen with the selected one visible', async () => {
  const page = await openPage();
  const count = await page.getByRole('tab').count();
  await page.getByRole('tab').last().click();
  for (const width of [1366, 1200, 1024, 768]) {
    await page.setViewportSize({width, height: 850});
    for (let i = 0; i < count; ++i) {  // once round, starting from the last one
      const {hidden, ...seen} = await page.evaluate(async () => {
        for (let frame = 0; frame < 3; ++frame) await new Promise(requestAnimationFrame);  // curves adapt to the width
        const list = document.querySelector('#tabs'), row = list.getBoundingClientRect();
        const chosen = list.querySelector('[aria-selected="true"]').getBoundingClientRect();
        return {rows: new Set([...list.children].map((tab) => tab.getBoundingClientRect().top)).size,
          inSight: chosen.left >= row.left && chosen.right <= row.right,
          wider: document.documentElement.scrollWidth > innerWidth, hidden: list.scrollWidth - list.clientWidth};
      });
      assert.deepEqual(seen, {rows: 1, inSight: true, wider: false}, `${width} pixels wide, after ${i} keys`);
      if (width !== 1024) assert.ok(hidden <= 0, `${hidden} pixels are not in sight`);
      await page.keyboard.press('ArrowRight');
    }
  }
  await page.close();
});

test('the time bar is shown with curves, and its keys work everywhere', async () => {
  const page = await openPage();
  for (const tab of await page.getByRole('tab').all()) {
    await tab.click();
    const name = (await tab.innerText()).trim();
    assert.equal(await page.locator('#time').isVisible(), kWithCurves.includes(name), name);
  }
  await page.getByRole('tab', {name: 'Camera'}).click();
  const paused = () => page.evaluate(() => window.darwinop.timeline.paused);
  await page.keyboard.press('p');
  assert.equal(await paused(), true);
  await Promise.all([page.waitForEvent('download'), page.keyboard.press('s')]);
  await page.keyboard.press('Escape');
  assert.equal(await paused(), false);
  await page.close();
});

const kGiven = {address: '10.0.0.7', user: 'robotis', key: '/keys/op2', port: 2222};
const kUsed = {address: '10.0.0.8', user: 'darwin', key: '', port: 0}, kOther = {...kUsed, address: '10.0.0.9'};

test('Transfer starts with the robot of --robot or the last one used, and keeps what was typed', async () => {
  const begun = async (known, typed) => {
    const page = await browser.newPage();
    const opened = new Promise((done) => page.routeWebSocket(/\/transfer$/, done).then(() => page.goto(shown.url)));
    const socket = await opened;
    await page.getByRole('tab', {name: 'Transfer'}).click();
    if (typed) await page.fill('#robot-address', typed);
    const sendKnown = (more) => socket.send(JSON.stringify({type: 'known', controllers: [], examples: [], trouble: '', ...more}));  // keep-word: member of the message
    sendKnown({robots: [kUsed], ...known});
    sendKnown({robots: [kOther, kUsed], ...known});  // another page has used a robot
    await page.locator('#robot-used option', {hasText: kOther.address}).waitFor({state: 'attached'});
    const values = await page.evaluate(() => ['address', 'user', 'key', 'port'].map((name) => document.querySelector(`#robot-${name}`).value));
    await page.close();
    return values;
  };
  assert.deepEqual(await begun({given: kGiven}), ['10.0.0.7', 'robotis', '/keys/op2', '2222']);
  assert.deepEqual(await begun({given: null}), ['10.0.0.8', 'darwin', '', '']);
  assert.deepEqual(await begun({given: kGiven}, 'mine'), ['mine', 'darwin', '', '']);
});
