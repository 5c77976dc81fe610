// Loop tab: wake-up latency, overruns, bus times, stale devices.
import {el, number, setText, withUnit} from './dom.js';

const kFigures = [
  ['Cycles', (m) => number(m.cycles)],
  ['Overruns, new / all', (m) => `${number(m.recent?.overruns)} / ${number(m.overruns)}`],
  ['Skipped cycles', (m) => number(m.skipped)],
  ['Wake-up, median', (m) => withUnit(m.wake_us?.p50, 0, 'µs')],
  ['Wake-up, 99 %', (m) => withUnit(m.wake_us?.p99, 0, 'µs')],
  ['Wake-up, worst', (m) => withUnit(m.wake_us?.max, 0, 'µs')],
  ['Bus, median', (m) => withUnit(m.bus_ms?.p50, 2, 'ms')],
  ['Bus, worst', (m) => withUnit(m.bus_ms?.max, 2, 'ms')],
  ['Slack, least 1 %', (m) => withUnit(m.slack_ms?.p1, 2, 'ms')],
  ['Retries', (m) => number(m.retries)],
  ['Incomplete cycles', (m) => number(m.incomplete)],
  ['Damaged frames', (m) => number(m.bad_checksums)],
  ['Reconnects', (m) => number(m.reconnects)],
  ['Dropped messages', (m) => number(m.lost)],
];

export class LoopPane {
  constructor() {
    this.values = kFigures.map(() => el('dd', {}, '—'));
    this.bars = el('div', {className: 'bars', role: 'img', ariaLabel: 'Histogram of wake-up latency'});
    this.stale = el('p', {}, '—');
    this.driver = el('p', {}, '—');
    this.hits = el('p', {}, '—');
    this.node = el('div', {className: 'pane'},
      el('dl', {className: 'figures'}, ...kFigures.map(([name], i) => el('div', {}, el('dt', {}, name), this.values[i]))),
      el('div', {}, el('h3', {}, 'Wake-up latency ', el('span', {className: 'unit'}, 'cycles (logarithmic) by latency in µs')),
        this.bars),
      el('div', {}, el('h3', {}, 'Stale devices'), this.stale),
      el('div', {}, el('h3', {}, 'Limit hits'), this.hits),
      el('div', {}, el('h3', {}, 'Driver'), this.driver));
  }

  begin() {}
  restyle() {}
  draw() {}
  update() {}

  /// A "loop" message.
  take(message) {
    kFigures.forEach(([, text], i) => setText(this.values[i], text(message)));
    setText(this.stale, message.stale?.length ? message.stale.join(', ') : 'none');
    setText(this.driver, this.driverText(message));
    const hits = Object.entries(message.limit_hits ?? {}).filter(([, n]) => n > 0);
    setText(this.hits, hits.length ? hits.map(([name, n]) => `${name} ${n}`).join(', ') : 'none');
    if (message.wake_histogram) this.draw_bars(message.wake_histogram);
  }

  driverText({driver, session}) {
    if (driver === null || driver === undefined) return 'none: the robot holds or is limp';
    return driver.pid === null ? 'a program of another user' : `process ${driver.pid}, session ${number(session)}`;
  }

  draw_bars({edges_us: edges, counts}) {
    const most = Math.log10(Math.max(...counts, 1) + 1);
    const name = (i) => (i === 0 ? `< ${edges[0]}` : i === edges.length ? `≥ ${edges.at(-1)}` : `${edges[i - 1]}`);
    this.bars.replaceChildren(...counts.map((count, i) => {
      const bar = el('b');
      bar.style.height = `${(Math.log10(count + 1) / most) * 78}%`;
      return el('div', {}, count > 0 ? String(count) : '', bar, name(i));
    }));
  }
}
