// End-to-end test of the robot window: real program, virtual robot with a moving head, real browser.
import assert from 'node:assert/strict';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createServer} from 'node:http';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {kNoProgram} from '../../window/page/src/messages.js';
import {rng, kMessages, spoilt} from './page/hostile_messages.mjs';
import {kAxe, startBrowser, startWindow} from './window_program.mjs';

const folder = mkdtempSync(join(tmpdir(), 'darwinop-window-'));
let browser, shown;

before(async () => {
  const report = join(folder, 'report.html');
  writeFileSync(report, '<!doctype html><title>gap</title><script>document.title = `gap of ${origin}`;</script>');
  [browser, shown] = await Promise.all([startBrowser(), startWindow('--robot', 'virtual', '--report', report, process.env.DARWINOP_HELLO)]);
});
after(async () => {
  await browser?.close();
  await shown?.end();
  rmSync(folder, {recursive: true});
});

async function openPage(options = {}, url = shown.url) {
  const page = await browser.newPage(options);
  const errors = [];
  page.on('pageerror', (error) => errors.push(error.message));
  await page.goto(url);
  await page.waitForFunction(() => window.darwinop?.view && window.darwinop.timeline.live?.count > 30);
  assert.deepEqual(errors, []);
  return page;
}

test('numbers, curves and 3D view follow the robot', async () => {
  const page = await openPage();
  const seen = () => page.waitForFunction(([before]) => {
    const {cells} = [...document.querySelectorAll('tbody tr')].find((row) => row.textContent.startsWith('Neck'));
    const angle = Number.parseFloat(cells[2].textContent);  // a dash until the first numbers are shown
    return (before === null ? !Number.isNaN(angle) : Math.abs(angle - before) > 3) && {angle};
  }, [first]).then((found) => found.jsonValue());
  let first = null;
  first = (await seen()).angle;
  await seen();
  const drawn = await page.evaluate(() => {
    const {view, timeline} = window.darwinop, store = timeline.live;
    return {turned: view.robot.find('Neck').quaternion.toArray(), fresh: store.newest, rows: store.count};
  });
  assert.ok(drawn.turned.every(Number.isFinite));
  assert.equal(await page.locator('#banner').isVisible(), false);
  assert.match(await page.locator('#pills').innerText(), /State\s*driven/);
  await page.close();
});

test('pause stops the curves, a drag zooms in, and CSV export saves the range shown', async () => {
  const page = await openPage();
  await page.getByRole('button', {name: 'Pause'}).click();
  const range = () => page.evaluate(() => window.darwinop.timeline.range);
  const paused = await range();
  await page.waitForTimeout(300);
  assert.deepEqual(await range(), paused);
  const plot = await page.locator('.u-over').first().boundingBox();
  await page.mouse.move(plot.x + plot.width * 0.9, plot.y + 20);
  await page.mouse.down();
  await page.mouse.move(plot.x + plot.width * 0.98, plot.y + 20, {steps: 4});
  await page.mouse.up();
  const [from, to] = await range();
  assert.ok(Math.abs(to - from - 0.08 * (paused[1] - paused[0])) < 0.1, `${from} to ${to}`);
  const [file] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('s')]);
  const [head, ...rows] = readFileSync(await file.path(), 'utf8').trim().split('\n');
  assert.match(head, /^time \[s\],cycle \[1\],ShoulderR\.goal \[rad\]/);
  const times = rows.map((row) => Number(row.split(',')[0]));
  assert.ok(times.length > 10 && times.every((time) => time >= from && time <= to));
  await page.keyboard.press('Escape');
  assert.equal(await page.evaluate(() => window.darwinop.timeline.paused), false);
  await page.close();
});

const tabsOf = (page) => page.getByRole('tab').count();

test('tabs follow the arrow keys, and every tab is accessible in light and dark mode', async () => {
  const page = await openPage({bypassCSP: true});  // for axe only
  await page.addScriptTag({path: kAxe});
  await page.locator('#tab-0').focus();
  for (let i = 0; i < await tabsOf(page); ++i) {
    assert.equal(await page.locator(`#tab-${i}`).getAttribute('aria-selected'), 'true');
    for (const colorScheme of ['light', 'dark']) {
      await page.emulateMedia({colorScheme});
      const {violations} = await page.evaluate(([whole, dark]) => window.axe.run(whole ? document : '#stage',
        {resultTypes: ['violations'], ...(dark ? {runOnly: ['color-contrast']} : {})}), [i === 0, colorScheme === 'dark']);
      assert.deepEqual(violations.map((one) => `${one.id}: ${one.nodes[0].html}`), [], `${colorScheme}, tab ${i}`);
    }
    await page.keyboard.press('ArrowRight');
  }
  assert.equal(await page.locator('#tab-0').getAttribute('aria-selected'), 'true', 'round');
  await page.keyboard.press('End');
  assert.equal(await page.getByRole('tab').last().getAttribute('aria-selected'), 'true');
  await page.close();
});

// Focusable elements in page order.
const kReachable = 'button:enabled, input:enabled, select:enabled, summary, a[href], [tabindex="0"]';

test('the keyboard reaches everything in order with a visible focus', async () => {
  const page = await openPage();
  for (let i = 0; i < await tabsOf(page); ++i) {
    await page.click(`#tab-${i}`);
    const wanted = await page.evaluate((which) => {
      document.body.tabIndex = -1;
      document.body.focus();
      const nodes = [...document.querySelectorAll(which)].filter((node) => node.tabIndex >= 0 && node.checkVisibility());
      window.wanted = nodes;
      return nodes.length;
    }, kReachable);
    for (let n = 0; n < wanted; ++n) {
      await page.keyboard.press('Tab');
      const {is, due, outline} = await page.evaluate((at) => {
        const {activeElement: node} = document, {outlineStyle, outlineWidth} = getComputedStyle(node);
        const name = (one) => one?.outerHTML.slice(0, 90);
        return {is: name(node), due: name(window.wanted[at]), outline: outlineStyle === 'none' ? 0 : Number.parseFloat(outlineWidth)};
      }, n);
      assert.equal(is, due, `tab ${i}`);
      assert.ok(outline >= 2, `one does not see that one is at ${is}`);
    }
  }
  await page.close();
});

test('a tablet in portrait mode does not scroll horizontally and has large enough buttons', async () => {
  const page = await openPage({viewport: {width: 820, height: 1180}, hasTouch: true});
  for (let i = 0; i < await tabsOf(page); ++i) {
    await page.tap(`#tab-${i}`);
    const {over, small} = await page.evaluate(() => {
      const size = (node) => (node.type === 'checkbox' && node.closest('label') || node).getBoundingClientRect();  // the label is clickable as well
      return {over: document.documentElement.scrollWidth - innerWidth,
        small: [...document.querySelectorAll('button, select, input')].filter((node) => node.checkVisibility() &&
          node.type !== 'range' && size(node).height < 28).map((node) => `${size(node).height}: ${node.outerHTML.slice(0, 80)}`)};
    });
    assert.ok(over <= 0, `tab ${i}: ${over} pixels too wide`);
    assert.deepEqual(small, [], `tab ${i}`);
  }
  await page.close();
});

test('recordings are overlaid with a time shift, and a report of twin and robot is linked', async () => {
  const page = await openPage();
  await page.getByRole('tab', {name: 'Compare'}).click();
  const log = (offset) => 'time_s,cycle,Neck.position [rad],Head.load\n' +
    [...Array(500).keys()].map((i) => `${7 + i * 0.016},${i},${Math.sin(i / 50) + offset},`).join('\n') + '\n';
  await page.setInputFiles('#compare-files', [
    {name: 'twin.csv', mimeType: 'text/csv', buffer: Buffer.from(log(0))},
    {name: 'robot.csv', mimeType: 'text/csv', buffer: Buffer.from(log(0.2))},
    {name: 'shopping.csv', mimeType: 'text/csv', buffer: Buffer.from('milk,2\n')}]);
  await page.getByText('shopping.csv is not a recording').waitFor();
  await page.selectOption('#compare-column', 'Neck.position');
  await page.waitForFunction(() => window.darwinop.compare.plot?.series.length === 3);
  await page.fill('#shift-1', '1.6');
  const [times, twin, robot] = await page.evaluate(() => window.darwinop.compare.plot.data.map((column) => [...column]));
  const at = (curve, time) => curve[times.findIndex((t) => Math.abs(t - time) < 1e-6)];
  assert.ok(Math.abs(at(twin, 0.8) - Math.sin(1)) < 1e-6);
  assert.ok(Math.abs(at(robot, 2.4) - Math.sin(1) - 0.2) < 1e-6);

  const [report] = await Promise.all([page.context().waitForEvent('page'), page.click('#gap-report')]);
  await report.waitForFunction(() => document.title.startsWith('gap of'));
  assert.equal(await report.title(), 'gap of null', 'it is nobody, and can reach nothing here');
  await page.close();
});

test('arbitrary messages of a robot neither break the page nor make it grow', async () => {
  const page = await openPage(), errors = [];
  page.on('pageerror', (error) => errors.push(error.stack));
  const good = await page.evaluate(async () => {
    const {feed} = window.darwinop;
    const said = ['hello', 'state', 'loop', 'faults'].map((type) => new Promise((done) =>
      feed.addEventListener(type, ({detail}) => done(detail), {once: true})));
    feed.socket.close();  // reconnects: a new "hello"
    return Promise.all(said);
  });
  const [hello] = good, random = rng(3);
  const texts = Array.from({length: 600}, (_, i) => spoilt([...good, ...kMessages.slice(4)][i % 7], random))
    .filter(({type, joints}) => type !== 'hello' || JSON.stringify(joints) === JSON.stringify(hello.joints))  // another robot
    .map((message) => JSON.stringify(message));
  for (const tab of [0, 1, 2, 5]) {
    await page.click(`#tab-${tab}`);
    await page.evaluate(async ([all, last]) => {
      const {feed, timeline} = window.darwinop, rows = timeline.live.data[0];
      for (const [i, text] of all.entries()) {
        feed.take(text);
        if (i % 40 === 0) await new Promise(requestAnimationFrame);
      }
      for (const bytes of [0, 1, 19, 20, 4000]) feed.take(new Uint8Array(bytes).fill(1).buffer);
      feed.take(JSON.stringify(last));
      if (timeline.live.data[0] !== rows) throw new Error('the record is another one');
    }, [texts, hello]);
  }
  assert.deepEqual(errors, []);
  await page.locator('#pills').filter({hasText: 'Statedriven'}).waitFor();
  await page.close();
});

test('without the secret path every request fails', async () => {
  const root = new URL('/', shown.url).href;
  for (const path of ['', 'window.js', 'body.json', '0123456789abcdef0123456789abcdef/', 'monitor'])
    assert.equal((await fetch(root + path)).status, 404, path);
});

test('a page of another origin can neither read nor subscribe', async () => {
  const elsewhere = createServer((_, answer) => answer.end('<!doctype html><title>elsewhere</title>')).listen(0, '127.0.0.1');
  await new Promise((done) => elsewhere.once('listening', done));
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${elsewhere.address().port}/`);
  const got = await page.evaluate(async (url) => {
    const read = await fetch(`${url}body.json`).then(() => 'read', () => 'refused');
    const listened = await new Promise((done) => {
      const socket = new WebSocket(`${url.replace('http', 'ws')}monitor`, 'darwinop-monitor.1');
      socket.onopen = () => done('listens');
      socket.onerror = () => done('refused');
    });
    return {read, listened};
  }, shown.url);
  elsewhere.close();
  await page.close();
  assert.deepEqual(got, {read: 'refused', listened: 'refused'});
});

test('when the program ends, the page marks its data as old', async () => {
  const page = await openPage();
  await shown.end();
  const banner = page.locator('#banner');
  await banner.waitFor({state: 'visible'});
  assert.ok((await banner.textContent()).includes(kNoProgram));
  assert.match(await page.locator('#pills').innerText(), /Battery\s*—/);
  await page.close();
});
