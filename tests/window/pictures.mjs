// Renders the images of docs/window.md:
//   DARWINOP_BIN=build/release/bin DARWINOP_NPM=build/npm/node_modules node tests/window/pictures.mjs docs/window [NAME …]
// For another tab add a line to kPictures.
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {smallPng} from './small_png.mjs';
import {compared, startStickingRobot} from './sticking_robot.mjs';
import {startBrowser, startProgram, startWindow} from './window_program.mjs';

const kMost = 90000;  // bytes of an image, because they are in the repository
const kWide = {width: 1200, height: 760}, kTablet = {width: 820, height: 1180}, kCamera = {width: 1280, height: 720}, kHigh = {width: 1280, height: 900};
// Walks without physics, so that it also stays upright on a busy computer.
const walker = [`${process.env.DARWINOP_BIN}/../controllers/05_walk/05_walk`, '--', '--seconds', '1000'];
const [folder, ...wanted] = process.argv.slice(2);
if (!folder) throw new Error('usage: pictures.mjs FOLDER [NAME …]');

/// `on`: window to use; `tab`; `prepare(page)`; `holds(page)`: whether the page still shows what it should, else once
/// more; `look`: options of the browser context.
const kPictures = [
  {name: 'servos', on: 'walker', tab: 'Servos', prepare: (page) => page.getByRole('button', {name: 'LegLowerR'}).click()},
  {name: 'curves', on: 'walker', tab: 'All curves'},
  {name: 'loop', on: 'walker', tab: 'Loop'},
  {name: 'tablet', on: 'walker', tab: 'Servos', look: {viewport: kTablet, hasTouch: true}},
  {name: 'compare', on: 'walker', tab: 'Compare', prepare: compare},
  {name: 'live', on: 'sticking', tab: 'Compare', prepare: live, look: {viewport: kHigh}},
  {name: 'faults', on: 'faulty', tab: 'Faults'},
  {name: 'walk', on: 'driven', tab: 'Steer', prepare: walk},
  {name: 'sensors', on: 'driven', tab: 'Steer', prepare: feelWalk, look: {colorScheme: 'dark'}},
  {name: 'pose', on: 'driven', tab: 'Steer', prepare: showPose},
  {name: 'camera', on: 'follower', tab: 'Camera', prepare: (page) => ball(page).waitFor(), holds: (page) => ball(page).isVisible(),
    look: {viewport: kCamera}},
].filter(({name}) => wanted.length === 0 || wanted.includes(name));

/// The ball near the centre: on a busy computer the head overshoots.
function ball(page) {
  return page.locator('#found-text', {hasText: /^Ball at \((1\d\d|2[0-2]\d), ([6-9]\d|1[0-7]\d)\)/});
}

async function compare(page) {
  const log = (late, high) => Buffer.from('time_s,cycle,LegLowerR.position [rad]\n' + [...Array(600).keys()].map((i) =>
    `${i * 0.016},${i},${(0.93 + high * Math.sin(i / 12 - late) ** 2).toFixed(4)}`).join('\n') + '\n');
  await page.setInputFiles('#compare-files', [{name: 'twin.csv', mimeType: 'text/csv', buffer: log(0, 0.5)},
    {name: 'robot.csv', mimeType: 'text/csv', buffer: log(0.2, 0.45)}]);
  await page.waitForFunction(() => window.darwinop.compare.plot?.series.length === 3);
}

async function live(page) {
  await page.click('#live-start');
  await compared(page, 'darwin-op');
  await page.waitForTimeout(12000);  // the arm moves
  await page.fill('#live-model', page.sticking.repaired);
  await page.click('#live-start');
  await compared(page, page.sticking.repaired);
  await page.waitForTimeout(8000);
}

async function walk(page) {
  await page.click('#take');
  await page.locator('body.driving').waitFor();
  await page.locator('#gait-part').fill('0.3');
  await page.hover('#go-forward');
  await page.mouse.down();
  await page.waitForTimeout(7000);
}

async function feelWalk(page) {
  await walk(page);
  await page.getByRole('tab', {name: 'Motion sensors'}).evaluate((tab) => tab.click());  // the pad is still held
}

async function showPose(page) {  // the robot is held in another pose, shown as limp
  await walk(page);
  await page.mouse.up();
  await page.evaluate(() => window.darwinop.steering.leave());
  await page.waitForFunction(() => window.darwinop.newest.state === 'holding');
  await page.evaluate(() => {
    const {feed} = window.darwinop, take = feed.take.bind(feed);
    feed.take = (data) => take(typeof data === 'string' ? data.replace('"state":"holding"', '"state":"limp"') : data);
  });
  await page.waitForFunction(() => window.darwinop.newest.state === 'limp');
  await page.click('#take');
  await page.locator('#pose').waitFor();
}

/// A robot with a discharging battery and a hot servo.
async function faulty() {
  const place = mkdtempSync(join(tmpdir(), 'darwinop-pictures-')), name = join(place, 'runtime');
  writeFileSync(join(place, 'script'), '0 voltage 10.5\n0 heat LegLowerR 68\n1 dead ArmLowerL\n');
  const robot = await startProgram('virtual-robot', ['--link', join(place, 'robot'), '--faults', join(place, 'script')], /port: .*\n/);
  const runtime = await startProgram('runtime', ['--robot', join(place, 'robot'), '--wait', '--name', name], /ready: /);
  const shown = await startWindow('--robot', 'runtime', '--name', name);
  return {...shown, end: async () => {
    await shown.end();
    await runtime.end();
    await robot.end();
    rmSync(place, {recursive: true});
  }};
}

/// The twin's head follows a ball.
async function follower() {
  process.env.DARWINOP_TWIN_BALL = 'circles';
  const shown = await startWindow(`${process.env.DARWINOP_BIN}/../controllers/04_visual_tracking/04_visual_tracking`);
  delete process.env.DARWINOP_TWIN_BALL;
  return shown;
}

const kWindows = {follower, sticking: startStickingRobot, walker: () => startWindow('--robot', 'virtual', ...walker), driven: () => startWindow('--robot', 'twin'), faulty};
const browser = await startBrowser();
let shown;
try {
  for (const on of new Set(kPictures.map((picture) => picture.on))) {
    shown = await kWindows[on]();
    for (const {name, tab, prepare, holds, look} of kPictures.filter((picture) => picture.on === on)) {
      const page = await browser.newPage({viewport: kWide, ...look});
      page.sticking = shown;
      await page.goto(shown.url);
      await page.waitForFunction(() => window.darwinop?.view && window.darwinop.timeline.live?.count > 30);
      await page.getByRole('tab', {name: tab}).click();
      await page.waitForTimeout(11000);  // the curves are full
      const path = join(folder, `${name}.png`);
      let shot;
      do {
        await prepare?.(page);
        await page.evaluate((at) => (at ? at.scrollIntoView() : scrollTo(0, 0)), await page.$(name === 'compare' ? '.logs' : 'no'));
        await page.waitForTimeout(500);
        shot = await page.screenshot();
      } while (holds && !await holds(page));
      const png = await smallPng(page, shot);
      await page.close();
      if (png.length > kMost) throw new Error(`${path} would have ${png.length} bytes, more than ${kMost}`);
      writeFileSync(path, png);
      console.log(`${path}: ${png.length} bytes`);
    }
    await shown.end();
  }
} finally {
  await browser.close();
  await shown?.end();
}
