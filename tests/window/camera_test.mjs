// Camera tab with the window's virtual robot: ball position, and the error without graphics.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {startBrowser, startWindow} from './window_program.mjs';

const kCamera = 6;
let browser;
before(async () => { browser = await startBrowser(); });
after(() => browser?.close());

/// Opens the camera of a window that is started with `words` and `settings`, does `act` with its page, and ends it.
async function look(words, settings, act) {
  const before = {...process.env};
  Object.assign(process.env, settings);
  const starting = startWindow(...words);
  process.env = before;
  const shown = await starting;
  try {
    const page = await browser.newPage();
    await page.goto(shown.url);
    await page.waitForFunction(() => window.darwinop?.newest);
    await page.click(`#tab-${kCamera}`);
    await act(page, shown);
    await page.close();
  } finally {
    await shown.end();
  }
}

const says = (page, id, text) => page.locator(id, {hasText: text}).waitFor();

test('finds a ball at its position, and not with another colour', () => look(['--robot', 'virtual'], {}, async (page) => {
  await says(page, '#found-text', /\(\d+, \d+\)/);
  // The reported position, the centre of the highlighted pixels, and the picture's colour there.
  const seen = await page.evaluate(() => {
    const said = document.getElementById('found-text').textContent.match(/\((\d+), (\d+)\)/).slice(1).map(Number);
    const {data} = document.getElementById('found').getContext('2d').getImageData(0, 0, 320, 240);
    let count = 0, x = 0, y = 0;
    for (let i = 0; i < 320 * 240; ++i) {
      if (data[4 * i] < 200 || data[4 * i + 1] > 50 || data[4 * i + 2] < 200) continue;
      ++count;
      x += i % 320;
      y += Math.floor(i / 320);
    }
    const [red, green] = document.getElementById('picture').getContext('2d').getImageData(...said, 1, 1).data;
    return {count, far: Math.hypot(said[0] - x / count, said[1] - y / count), red, green};
  });
  assert.ok(seen.count > 300 && seen.far < 3 && seen.red > 120 && seen.green > 60 && seen.green < 0.7 * seen.red, JSON.stringify(seen));
  await page.locator('#vision-hue').fill('200');
  await says(page, '#found-text', /^No ball/);
  assert.match(await page.textContent('#vision-code'), /, 200, 20, 50, 45, 0, 30};$/);
  await page.uncheck('#look-for');
  assert.equal(await page.textContent('#found-text'), '');
}));

test('page and controller see the ball in front of the twin', () =>
  look([process.env.DARWINOP_TRACKING], {DARWINOP_TWIN_BALL: 'rests'}, async (page, shown) => {
    for (let i = 0; i < 200 && !shown.printed().includes('I see the ball'); ++i) await page.waitForTimeout(100);  // no message: the example's output
    assert.match(shown.printed(), /I see the ball/);  // no message: the example's output
    await page.waitForFunction(() => {
      const place = document.getElementById('found-text').textContent.match(/\((\d+), (\d+)\)/);
      return place && Math.hypot(place[1] - 160, place[2] - 120) < 40;
    });
    if (process.env.SHOTS) await page.screenshot({path: `${process.env.SHOTS}/camera.png`});
  }));

test('reports why the twin cannot render camera pictures', () => look([], {DARWINOP_TWIN_GL: 'off'}, async (page) => {
  await says(page, '#picture-note', /^No picture: the virtual robot cannot render camera pictures: .*DARWINOP_TWIN_GL/);
  assert.equal(await page.textContent('#found-text'), '');
}));
