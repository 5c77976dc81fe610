// The robot window in a real browser, beside a twin that walks: how smooth it is, and whether it grows. Ten times it says
// what it has seen; it ends with an error when memory has grown. `./dev bench window [SECONDS [TAB]]`
import {readFileSync, readdirSync} from 'node:fs';
import {loadavg} from 'node:os';
import {startBrowser, startWindow} from '../window/window_program.mjs';

const kLong_ms = 25;                // a frame is lost
// More than at first, when the record of five minutes is full or nearly as large as it will be: it grows.
const kGrowth = 1.1, kSlack_MB = {heap: 2, page: 24, browser: 24, program: 4, robot: 4};

const [seconds = '60', tab = 'All curves', ...words] = process.argv.slice(2);
const length = Number(seconds);
const walk = [`${process.env.DARWINOP_BIN}/../controllers/05_walk`, '--', '--seconds', '1000000'];
const [browser, shown] = await Promise.all([startBrowser(), startWindow(...(words.length > 0 ? words : walk))]);
const page = await browser.newPage({viewport: {width: 1366, height: 850}});
const tools = await browser.newBrowserCDPSession(), look = await page.context().newCDPSession(page);

// Of a process and, where they are ours, what it has started: resident memory, MB.
const statusOf = (pid, what) => Number(readFileSync(`/proc/${pid}/status`, 'utf8').match(new RegExp(`${what}:\\s*(\\d+)`))[1]);
function family(pid) {
  const all = readdirSync('/proc').filter((name) => /^\d+$/.test(name)).map(Number);
  const parents = new Map(all.flatMap((one) => { try { return [[one, statusOf(one, 'PPid')]]; } catch { return []; } }));
  const found = [pid];
  for (const one of found) for (const [child, parent] of parents) if (parent === one) found.push(child);
  return found;
}
const resident = (pids) => pids.reduce((sum, pid) => sum + statusOf(pid, 'VmRSS') / 1024, 0);

async function memory() {
  await look.send('HeapProfiler.collectGarbage');
  const {usedSize, backingStorageSize = 0} = await look.send('Runtime.getHeapUsage');
  const {processInfo} = await tools.send('SystemInfo.getProcessInfo');
  return {heap: (usedSize + backingStorageSize) / 2 ** 20, program: resident([shown.process.pid]),
    page: resident(processInfo.filter(({type}) => type === 'renderer').map(({id}) => id)),
    browser: resident(processInfo.filter(({type}) => type !== 'renderer').map(({id}) => id)),
    robot: resident(family(shown.process.pid).slice(1))};
}

/// CPU time so far, s: {page, browser, program, robot}
async function work() {
  const {processInfo} = await tools.send('SystemInfo.getProcessInfo');
  const ticks = (pid) => {
    const fields = readFileSync(`/proc/${pid}/stat`, 'utf8').replace(/^.*\) /, '').split(' ');
    return (Number(fields[11]) + Number(fields[12])) / 100;
  };
  const sum = (pids) => pids.reduce((all, pid) => all + ticks(pid), 0);
  const [program, ...robot] = family(shown.process.pid);
  return {page: sum(processInfo.filter(({type}) => type === 'renderer').map(({id}) => id)),
    browser: sum(processInfo.filter(({type}) => type !== 'renderer').map(({id}) => id)), program: ticks(program), robot: sum(robot)};
}

const quantile = (sorted, part) => sorted[Math.min(Math.floor(part * sorted.length), sorted.length - 1)] ?? NaN;
const figures = (record) => Object.entries(record).map(([name, value]) => `${name} ${value.toFixed(1)}`).join(', ');

/// Frames of each whole second, how many were long, and the longest, ms; the page counts for itself.
async function frames(duration) {
  await page.evaluate((long) => {
    const seen = window.seen = {counts: [], long: 0, longest: 0, ends: false};
    let begin = null, before, count = 0;
    requestAnimationFrame(function tick() {
      if (seen.ends) return;
      const now = performance.now();
      begin ??= now;
      if (now - before > long) ++seen.long;
      seen.longest = Math.max(seen.longest, now - (before ?? now));
      before = now;
      if (now - begin >= 1000) {
        seen.counts.push(count * 1000 / (now - begin));
        begin = now;
        count = 0;
      }
      ++count;
      requestAnimationFrame(tick);
    });
  }, kLong_ms);
  await page.waitForTimeout(duration * 1000);
  const seen = await page.evaluate(() => { window.seen.ends = true; return window.seen; });
  seen.counts.sort((a, b) => a - b);
  return seen;
}

const all = [];
let failed = false, long = 0;
try {
  await page.goto(shown.url);
  await page.waitForFunction(() => window.darwinop?.view && window.darwinop.timeline.live?.count > 30);
  await page.getByRole('tab', {name: tab}).click();
  await page.waitForTimeout(Math.min(length / 10, 8) * 1000);
  const parts = length >= 20 ? 10 : 1, each = length / parts;
  let first = null, last = null;
  for (let part = 0; part < parts; ++part) {
    const before = await work(), seen = await frames(each), after = await work();
    last = await memory();
    first ??= last;
    all.push(...seen.counts);
    long += seen.long;
    const cpu = Object.fromEntries(Object.keys(after).map((who) => [who, 100 * (after[who] - before[who]) / each]));
    console.log(`${((part + 1) * each).toFixed(0)} s: frames/s median ${quantile(seen.counts, 0.5).toFixed(1)}, ` +
      `5 % ${quantile(seen.counts, 0.05).toFixed(1)}; ${seen.long} over ${kLong_ms} ms, longest ${seen.longest.toFixed(0)} ms; ` +
      `MB: ${figures(last)}; % CPU: ${figures(cpu)}; load ${loadavg()[0].toFixed(1)}`);
  }
  all.sort((a, b) => a - b);
  console.log(`${tab}: least ${all[0]?.toFixed(1)} frames/s; ${long} frames over ${kLong_ms} ms in ${length} s`);
  const bench = (what, ours, peer, unit) => console.log(`bench: window_${what} ours=${ours.toFixed(1)} peer=${peer.toFixed(1)} ` +
    `ratio=${(ours / peer).toFixed(3)} unit=${unit}`);
  bench('frames', quantile(all, 0.5), 60, '1/s');  // peer: the screen
  bench('frames_p5', quantile(all, 0.05), 60, '1/s');
  for (const line of shown.said().match(/.* has ended .*/g) ?? []) console.log(`meanwhile: ${line}`);
  for (const [what, slack] of Object.entries(kSlack_MB)) {
    bench(`${what}_memory`, last[what], first[what], 'MB');  // peer: itself, after a tenth of the time
    const grown = last[what] > first[what] * kGrowth + slack;
    failed ||= grown;
    if (grown) console.log(`the memory of ${what} GROWS`);
  }
} finally {
  await browser.close();
  await shown.end();
}
process.exit(failed ? 1 : 0);
