// Curves over time: uPlot on the store, for the timeline's range.
import uPlot from 'uplot';
import {colour, el, number, setText} from './dom.js';
import {kGraphicsCard} from './graphics.js';

const kEmpty = [null, null];
// Without a graphics card, lines of 1 px are drawn four times as fast.
const kLine_px = kGraphicsCard ? 1.6 : 1;

export class CurvePlot {
  /// curves: [{key, name, colour, scale}]; `span`: [low, high], always visible; `least`: minimum height of
  /// the y range, so that noise stays small. `scale` multiplies stored values, for degrees.
  constructor(timeline, {title, unit, curves, span = kEmpty, least = 0, height = 170, digits = 2, plain = false}) {
    this.timeline = timeline;
    this.span = span;
    this.least = least;
    this.digits = digits;
    this.unit = unit;
    this.plain = plain;
    this.height = height;
    this.title = el('h3', {}, title, ' ', el('span', {className: 'unit'}, unit));
    this.box = el('div', {className: 'plot-box'});
    this.keys = el('div', {className: 'key'});
    this.node = el('div', {className: 'plot'}, el('div', {className: 'plot-head'}, this.title, this.keys), this.box);
    this.columns = [[]];
    this.show(curves);
    this.box.addEventListener('wheel', (event) => this.wheel(event), {passive: false});
    new ResizeObserver(() => this.fit()).observe(this.box);
  }

  /// Replaces the curves.
  show(curves, title = null) {
    this.curves = curves;
    if (title) this.title.firstChild.data = title;
    while (this.columns.length <= curves.length) this.columns.push([]);
    this.columns.length = curves.length + 1;
    this.keys.replaceChildren();
    this.values = curves.map((curve) => {
      const value = el('span');
      const line = el('i');
      line.style.background = colour(curve.colour);
      if (!this.plain) this.keys.append(line, `${curve.name} `, value, ' ');
      return value;
    });
    this.build();
  }

  /// Creates the plot again, for example after a change of the colour scheme.
  build() {
    this.plot?.destroy();
    const quiet = colour('quiet'), line = colour('line');
    const axis = {stroke: quiet, grid: {stroke: line, width: 1}, ticks: {show: false}, font: '12px system-ui, sans-serif'};
    const options = {
      width: Math.max(this.box.clientWidth, 100),
      height: this.height,
      legend: {show: false},
      cursor: {sync: {key: 'time'}, drag: {x: true, y: false, setScale: false}, points: {show: !this.plain}},
      scales: {x: {time: false}, y: {range: (_, low, high) => this.reach(low, high)}},
      axes: this.plain
        ? [{show: false}, {show: false}]
        : [{...axis, size: 28, values: (_, all) => all.map((t) => `${Number(t.toFixed(3))} s`)}, {...axis, size: 50}],
      series: [{}, ...this.curves.map((curve) => ({stroke: colour(curve.colour), width: kLine_px, points: {show: false},
        dash: curve.dash}))],
      hooks: {setSelect: [(u) => this.select(u)]},
    };
    if (this.plain) options.padding = [4, 2, 4, 2];
    this.plot = new uPlot(options, this.columns, this.box);
    this.plot.over.addEventListener('dblclick', () => this.timeline.whole());
  }

  fit() {
    const width = this.box.clientWidth;
    if (width > 0 && width !== this.plot.width) this.plot.setSize({width, height: this.height});
  }

  // y range: span and data with a margin.
  reach(low, high) {
    const [least, most] = this.span;
    let from = low ?? least ?? 0, to = high ?? most ?? 1;
    if (least !== null) from = Math.min(from, least);
    if (most !== null) to = Math.max(to, most);
    const air = Math.max((to - from) * 0.06, (this.least - (to - from)) / 2);
    return [from - air, to + air];
  }

  draw() {
    const {range, store} = this.timeline;
    if (!range || this.box.clientWidth === 0) return;
    const {origin} = store;
    const first = Math.max(store.find(range[0]) - 1, 0), last = Math.min(store.find(range[1]) + 1, store.count);
    const times = this.columns[0];
    store.read(0, first, last, times);
    for (let n = 0; n < times.length; ++n) times[n] -= origin;
    this.curves.forEach((curve, i) => {
      const into = this.columns[i + 1];
      store.read(store.index.get(curve.key), first, last, into);
      if (curve.scale) for (let n = 0; n < into.length; ++n) if (into[n] !== null) into[n] *= curve.scale;
    });
    this.plot.batch(() => {
      this.plot.setData(this.columns, false);
      this.plot.setScale('x', {min: range[0] - origin, max: range[1] - origin});
    });
    if (!this.plain) this.update();
  }

  // Values at the cursor, or the newest.
  update() {
    const at = this.plot.cursor.idx ?? this.columns[0].length - 1;
    this.values.forEach((value, i) => {
      const shown = this.columns[i + 1][at];
      setText(value, number(shown, this.digits));
    });
  }

  // Time on the robot's clock.
  timeAt(left) { return this.plot.posToVal(left, 'x') + this.timeline.store.origin; }

  select(u) {
    if (u.select.width < 5) return;
    this.timeline.zoom(this.timeAt(u.select.left), this.timeAt(u.select.left + u.select.width));
    u.setSelect({left: 0, width: 0, top: 0, height: 0}, false);
  }

  wheel(event) {
    if (!event.ctrlKey && !this.timeline.paused) return;  // leaves the event to the page
    event.preventDefault();
    const left = event.clientX - this.plot.over.getBoundingClientRect().left;
    this.timeline.scale(event.deltaY > 0 ? 1.25 : 0.8, this.timeAt(left));
  }
}
