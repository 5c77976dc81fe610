// Driving from the page, through the real lease, on a virtual robot.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {message} from './messages.mjs';
import {startBrowser, startWindow, takeRobot} from './window_program.mjs';

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
  await page.waitForFunction(() => window.darwinop?.view && window.darwinop.timeline.live?.count > 30);
  return page;
}

async function drive(page) {
  await takeRobot(page);
  await stateIs(page, 'driven');
}

const stateIs = (page, state) => page.waitForFunction((wanted) =>
  document.getElementById('pills').textContent.includes(`State${wanted}`), state);

const newest = (page, key) => page.evaluate((name) => {
  const {live} = window.darwinop.timeline;
  return live.at(live.index.get(name), live.count - 1);
}, key);

/// Repeats `act` until the measured joint has moved by more than `by`, rad: on a busy computer the page may lose the session.
async function moves(page, joint, by, act) {
  for (let tries = 1; ; ++tries) {
    if (!(await page.evaluate(() => window.darwinop.steering.drives))) await drive(page);
    const from = await newest(page, `${joint}.position`);
    await act();
    const followed = page.waitForFunction(([key, before, far]) => {
      const {live} = window.darwinop.timeline;
      return Math.abs(live.at(live.index.get(key), live.count - 1) - before) > far;
    }, [`${joint}.position`, from, by], {timeout: 5000});
    if (await followed.then(() => true, () => false)) return;
    assert.ok(tries < 4, `${joint} does not follow`);
  }
}

test('a slider moves its joint, and a dragged arm follows the pointer', async () => {
  const page = await openPage();
  await drive(page);
  await page.click('#tab-3');
  await moves(page, 'Neck', 0.25, async () => {
    await page.focus('#aim-Neck');
    for (let i = 0; i < 40; ++i) await page.keyboard.press('ArrowRight');
  });

  const handAt = () => page.evaluate(() => {
    const {view} = window.darwinop, mesh = view.robot.find('ArmLowerL').children.find((child) => child.isMesh);
    const {min, max} = mesh.geometry.boundingBox, box = view.canvas.getBoundingClientRect();
    const at = min.clone().add(max).multiplyScalar(0.5).applyMatrix4(mesh.matrixWorld).project(view.camera);
    return {x: box.left + ((at.x + 1) / 2) * box.width, y: box.top + ((1 - at.y) / 2) * box.height};
  });
  let before_drag;
  await moves(page, 'ArmLowerL', 0.25, async () => {
    before_drag = await handAt();
    await page.mouse.move(before_drag.x, before_drag.y);
    await page.mouse.down();
    await page.mouse.move(before_drag.x, before_drag.y - 90, {steps: 15});
    await page.mouse.up();
  });
  assert.ok((await handAt()).y < before_drag.y - 5, 'the hand went up');

  // A tablet beside the robot, which does not drive, stops it as well.
  const tablet = await openPage();
  await tablet.click('#stop');
  await page.locator('body:not(.driving)').waitFor();
  await stateIs(page, 'holding');
  await tablet.close();
  await page.close();
});

test('one page drives; when it is closed the robot holds and another page may drive', async () => {
  const first = await openPage(), second = await openPage();
  await drive(first);
  await second.click('#take');
  await second.getByText(message('kAnotherPageDrives')).waitFor();
  await first.click('#tab-3');
  await first.locator('#aim-Head').fill('30');
  await first.close();
  await stateIs(second, 'holding');
  assert.ok(Number.isFinite(await newest(second, 'Head.goal')), 'it still has a goal: it is not limp');
  await drive(second);
  await second.close();
});

test('a page without heartbeat stops driving', async () => {
  const page = await openPage();
  await drive(page);
  await page.evaluate(() => { window.darwinop.steering.send = () => {}; });
  await page.getByText(message('kNoHeartbeat')).waitFor();
  await stateIs(page, 'holding');
  await page.close();
});
