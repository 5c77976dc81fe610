// Walk, motion pages and torque from the page on the physics twin.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {kNoData, kPoseUnknown, kStandingStill} from '../../window/page/src/messages.js';
import {message} from './messages.mjs';
import {kAxe, startBrowser, startWindow, takeRobot} from './window_program.mjs';

let browser, shown, page;

before(async () => {
  [browser, shown] = await Promise.all([startBrowser(), startWindow('--robot', 'twin')]);
  page = await browser.newPage({viewport: {width: 1366, height: 850}, bypassCSP: true});
  await page.goto(shown.url);
  await page.waitForFunction(() => window.darwinop?.view && window.darwinop.timeline.live?.count > 30);
  await page.addScriptTag({path: kAxe});
  await takeRobot(page);
  await page.click('#tab-3');
});
after(async () => {
  await browser?.close();
  await shown?.end();
});

/// Starts driving again if the page has lost the session on a busy computer.
const drive = () => takeRobot(page);

async function isAccessible() {
  const {violations} = await page.evaluate(() => window.axe.run({resultTypes: ['violations']}));
  assert.deepEqual(violations.map((one) => `${one.id}: ${one.nodes[0].html}`), []);
}

/// {low, high} of a column over the last seconds, in its unit.
const reach = (key, seconds) => page.evaluate(([name, s]) => {
  const {live} = window.darwinop.timeline, values = [];
  live.read(live.index.get(name), live.find(live.newest - s), live.count, values);
  const known = values.filter((value) => value !== null);
  return {low: Math.min(...known), high: Math.max(...known)};
}, [key, seconds]);

const gaitStatusIs = (text) => page.locator('#gait [role=status]').filter({hasText: text}).waitFor();

test('walks while the pad is held and stands after its release', async () => {
  let knee;
  await page.locator('#gait-part').fill('0.3');  // small steps: on a busy computer the twin's balance is late
  for (let tries = 0, walked = false; !walked; ++tries) {
    assert.ok(tries < 4, 'it does not walk for long enough');
    await drive();
    await page.hover('#go-forward');
    await page.mouse.down();
    await page.waitForTimeout(5800);  // including 3 s to get up from the start pose
    walked = (await page.locator('#gait [role=status]').innerText()) === 'Walking';
    knee = await reach('LegLowerR.position', 1.5);
    if (process.env.SHOTS) await page.screenshot({path: `${process.env.SHOTS}/walk.png`});
    await page.mouse.up();
  }
  await drive();
  await gaitStatusIs(kStandingStill);
  await page.waitForTimeout(1200);
  assert.ok(knee.high - knee.low > 0.3, `the knee moves: ${JSON.stringify(knee)}`);
  const still = await reach('LegLowerR.position', 0.5), up = await reach('accelerometer.z', 0.5);
  assert.ok(still.high - still.low < 0.05, `it stands still: ${JSON.stringify(still)}`);
  assert.ok(up.low > 7, `it stands: ${JSON.stringify(up)}`);
});

test('walks with keys, and stands when the page loses the focus', async () => {
  await drive();
  await page.keyboard.down('x');
  await gaitStatusIs('Walking');
  await page.evaluate(() => dispatchEvent(new Event('blur')));
  await gaitStatusIs(kStandingStill);
  await page.keyboard.up('x');
});

test('a motion page is played to its end', async () => {
  await drive();
  const button = page.getByRole('button', {name: 'walkready'});
  await button.click();
  await page.locator('#pages button[aria-pressed=true]').waitFor();
  if (process.env.SHOTS) await page.screenshot({path: `${process.env.SHOTS}/page.png`});
  await page.waitForFunction(() => !document.querySelector('#pages button[aria-pressed=true]'));
  await button.and(page.locator(':enabled')).waitFor();
});

test('an arm goes limp after a warning and gets its torque back at its position', async () => {
  await drive();
  await page.click('#torque-left_arm');
  if (process.env.SHOTS) await page.screenshot({path: `${process.env.SHOTS}/warning.png`});
  await isAccessible();  // while driving with an open warning; takes CPU time
  await drive();
  if (!(await page.locator('#limp-left_arm').isVisible())) await page.click('#torque-left_arm');
  await page.click('#limp-left_arm');
  await page.getByRole('button', {name: 'Left arm is limp'}).waitFor();
  const goal = () => page.evaluate(() => {
    const {live} = window.darwinop.timeline;
    return live.at(live.index.get('ArmLowerL.goal'), live.count - 1);
  });
  await page.waitForFunction(() => {
    const {live} = window.darwinop.timeline;
    return Number.isNaN(live.at(live.index.get('ArmLowerL.goal'), live.count - 1));
  });
  assert.ok(await page.locator('#aim-ArmLowerL').isDisabled());
  await page.hover('#go-forward');
  await page.mouse.down();
  await page.getByText(message('kWalkRequiresTorque')).waitFor();
  await page.mouse.up();
  await page.click('#torque-left_arm');
  await page.waitForFunction(() => {
    const {live} = window.darwinop.timeline;
    return Number.isFinite(live.at(live.index.get('ArmLowerL.goal'), live.count - 1));
  });
  const hangs = await reach('ArmLowerL.position', 0.3);
  assert.ok(Math.abs(await goal() - hangs.high) < 0.2);
});

test('a page without heartbeat during a walk completes its step', async () => {
  await drive();
  await page.keyboard.down('x');
  await gaitStatusIs('Walking');
  await page.waitForTimeout(2500);  // it stands and is calibrated: walking by now
  await page.evaluate(() => { window.darwinop.steering.send = () => {}; });
  await page.getByText(message('kNoHeartbeat')).waitFor();
  await page.keyboard.up('x');
  await page.waitForFunction(() => document.getElementById('pills').textContent.includes('Stateholding'));
  await page.waitForTimeout(700);
  const [right, left] = [await reach('LegLowerR.goal', 0.3), await reach('LegLowerL.goal', 0.3)];
  for (const knee of [right.low, -left.low])  // of the stance, 2653 ticks
    assert.ok(Math.abs(knee - 0.928) < 0.03, `on both legs, as before the walk: ${JSON.stringify([right, left])}`);
  await page.evaluate(() => { delete window.darwinop.steering.send; });
});

test('a robot out of its start pose is driven only after confirmation', async () => {
  await page.evaluate(() => window.darwinop.steering.leave());
  await page.locator('body:not(.driving)').waitFor();
  await page.waitForFunction(() => document.getElementById('pills').textContent.includes('Stateholding'));
  await page.evaluate(() => {
    const {feed} = window.darwinop;
    feed.socket.onmessage = ({data}) => feed.take(typeof data === 'string' ? data.replace(/"state":"\w+"/, '"state":"limp"') : data);
  });
  await page.waitForFunction(() => window.darwinop.newest.state === 'limp');
  await page.click('#take');
  await page.locator('#pose').waitFor();
  assert.match(await page.locator('#pose').innerText(), /LegLowerR is \d+° off/);
  if (process.env.SHOTS) await page.screenshot({path: `${process.env.SHOTS}/pose.png`});
  await isAccessible();
  await page.click('#pose-retry');
  assert.ok(await page.locator('#pose').isVisible());
  await page.click('#pose-cancel');
  assert.ok(!(await page.evaluate(() => window.darwinop.steering.drives)));
  await page.click('#take');
  await page.click('#pose-go');
  await page.locator('body.driving').waitFor();
  await page.evaluate(() => window.darwinop.steering.stop());
  await page.locator('body:not(.driving)').waitFor();
  await page.evaluate(() => { window.darwinop.feed.socket.onmessage = null; });
  await page.getByText(kNoData).waitFor();
  await page.click('#take');  // held, according to the last state
  await page.getByText(kPoseUnknown).waitFor();
  await page.click('#pose-cancel');
});
