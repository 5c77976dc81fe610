// Live comparison: a virtual robot whose elbow sticks, beside a twin without and then with that friction.
import assert from 'node:assert/strict';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {compared, startStickingRobot} from './sticking_robot.mjs';
import {startBrowser} from './window_program.mjs';

let browser, shown;

before(async () => {
  [browser, shown] = await Promise.all([startBrowser(), startStickingRobot()]);
});
after(async () => {
  await browser?.close();
  await shown?.end();
});

async function openCompare() {
  const page = await browser.newPage();
  await page.goto(shown.url);
  await page.waitForFunction(() => window.darwinop?.live.state && window.darwinop.timeline.live?.count > 30);
  await page.getByRole('tab', {name: 'Compare'}).click();
  return page;
}
const cells = (page, joint) => page.evaluate((name) =>
  [...[...document.querySelectorAll('[aria-label="Residuals of the joints"] tbody tr')].find((row) => row.cells[0].textContent === name).cells].map((cell) => cell.textContent), joint);

test('a residual shrinks when the model gets the effect that was found', async () => {
  const page = await openCompare();
  assert.equal((await cells(page, 'ArmLowerR'))[1], '—', 'nothing is compared yet');
  assert.equal(await page.inputValue('#live-model'), 'darwin-op');
  await page.click('#live-start');
  const elbow = async () => (await cells(page, 'ArmLowerR')).map(Number);
  await compared(page, 'darwin-op');
  await page.waitForFunction(() => window.darwinop.live.state.signals.position_mrad.rms[4] > 5, null, {timeout: 60_000});  // the arm moves
  const [, plain] = await elbow();
  assert.ok(plain > 5, `${plain} mrad`);
  assert.ok(plain > 3 * Number((await cells(page, 'ShoulderR'))[1]), 'the elbow stands out');
  await page.fill('#live-model', shown.repaired);
  await page.click('#live-start');
  await compared(page, shown.repaired);
  const [, now, , was] = await elbow();
  assert.ok(was > 5 && now < was / 2, `${was} -> ${now} mrad`);
  assert.match(await page.locator('#live-before').innerText(), /darwin-op/);
  await page.close();
});

test('two pages see one comparison, which ends with the last of them', async () => {
  const [first, second] = [await openCompare(), await openCompare()];
  await first.selectOption('#live-support', 'floor');
  await first.click('#live-start');
  await second.waitForFunction(() => window.darwinop.live.state.runs && window.darwinop.live.state.setting.support === 'floor');
  await first.close();
  await second.waitForFunction(() => window.darwinop.live.state.cycles > 100);
  await second.close();
  const third = await openCompare();
  assert.equal(await third.evaluate(() => window.darwinop.live.state.runs), false);
  await third.close();
});

test('a model that cannot be read is named, and nothing is compared', async () => {
  const page = await openCompare();
  await page.fill('#live-model', join(shown.folder, 'none.ini'));
  await page.press('#live-model', 'Enter');
  await page.waitForFunction(() => document.querySelector('#live-status').textContent.includes('none.ini:') ||
    window.darwinop.live.state.error.includes('none.ini'));
  assert.equal((await cells(page, 'ArmLowerR'))[1], '—');
  await page.click('#live-stop');
  await page.waitForFunction(() => !window.darwinop.live.state.runs);
  await page.close();
});
