// Compare tab: the live comparison with the twin; one column of several recordings, with time shifts.
import uPlot from 'uplot';
import {colour, el, setText} from './dom.js';
import {kMostRows, LogFile} from './log_file.js';

const kMostFiles = 6;
const kColours = ['actual', 'target', 'third', 'bad', 'quiet', 'warn'];
const kDashes = [undefined, undefined, undefined, [6, 3], [2, 3], [8, 3, 2, 3]];  // distinguishable without colour
const kFirstChoice = 'LegLowerR.position';

export class ComparePane {
  /// `live`: LivePane.
  constructor(live) {
    this.live = live;
    this.logs = [];  // {log, shift, data, key}
    this.pick = el('input', {type: 'file', id: 'compare-files', accept: '.csv,text/csv', multiple: true});
    this.pick.addEventListener('change', () => this.add([...this.pick.files]));
    this.column = el('select', {id: 'compare-column'});
    this.column.addEventListener('change', () => this.load());
    this.list = el('ul', {className: 'logs'});
    this.status = el('p', {className: 'note', role: 'status'});
    this.box = el('div', {className: 'plot-box'});
    this.report = el('p', {className: 'note'});
    this.node = el('div', {className: 'pane'}, live.node, el('h2', {}, 'Recordings'),
      el('p', {className: 'note'}, 'Choose two or more recordings of darwinop run --record, or CSV files saved by this page. They are not uploaded.'),
      el('div', {className: 'choose'}, el('label', {htmlFor: 'compare-files'}, 'Recordings'), this.pick,
        el('label', {htmlFor: 'compare-column'}, 'Curve'), this.column),
      this.list, this.status, this.box, this.report);
    new ResizeObserver(() => this.plot?.setSize({width: Math.max(this.box.clientWidth, 100), height: 320})).observe(this.box);
    fetch('report.json').then((answer) => answer.json()).then(({name}) => this.linkReport(name)).catch(() => {});
  }

  begin(joints) { this.live.begin(joints); }
  shown(is_shown) { this.live.shown(is_shown); }
  draw() {}
  update() {}
  restyle() { this.build(); }

  linkReport(name) {
    if (name === null) return setText(this.report, 'darwinop window --report FILE links a report of darwinop gap here.');
    return this.report.replaceChildren('Report of darwinop gap: ',
      el('a', {href: 'report.html', target: '_blank', rel: 'noopener noreferrer', id: 'gap-report'}, name));
  }

  async add(files) {
    const errors = [];
    for (const file of files) {
      if (this.logs.length === kMostFiles) { errors.push(`at most ${kMostFiles} recordings at once`); break; }
      try {
        this.logs.push({log: await LogFile.open(file), shift: 0, data: null});
      } catch (error) {
        errors.push(error.message);
      }
    }
    this.pick.value = '';
    this.offer();
    await this.load(errors);
  }

  remove(entry) {
    this.logs = this.logs.filter((other) => other !== entry);
    this.offer();
    this.load();
    this.pick.focus();
  }

  // Columns of all recordings.
  offer() {
    const names = [...new Set(this.logs.flatMap(({log}) => log.names))];
    const chosen = names.includes(this.column.value) ? this.column.value : names.includes(kFirstChoice) ? kFirstChoice : names[0];
    this.column.replaceChildren(...names.map((name) => el('option', {value: name, selected: name === chosen}, name)));
  }

  async load(errors = []) {
    const name = this.column.value, turn = (this.turn = (this.turn ?? 0) + 1);
    for (const entry of this.logs) {
      setText(this.status, `Reading ${entry.log.name} …`);
      try {
        entry.data = await entry.log.read(name);
      } catch (error) {
        entry.data = {times: [], values: [], cut: false};
        errors.push(error.message);
      }
      if (turn !== this.turn) return;  // another column was chosen in the meantime
      if (entry.data.cut) errors.push(`${entry.log.name}: only the first ${kMostRows} rows are shown`);
      if (!entry.log.names.includes(name)) errors.push(`${entry.log.name} has no column ${name}`);
    }
    setText(this.status, errors.join('. '));
    this.showList();
    this.build();
  }

  showList() {
    this.list.replaceChildren(...this.logs.map((entry, i) => {
      const line = el('i'), shift = el('input', {type: 'number', step: '0.1', value: String(entry.shift), id: `shift-${i}`});
      line.style.background = colour(kColours[i]);
      shift.addEventListener('input', () => { entry.shift = Number(shift.value) || 0; this.build(); });
      const away = el('button', {type: 'button', ariaLabel: `Remove ${entry.log.name}`}, '×');
      away.addEventListener('click', () => this.remove(entry));
      return el('li', {className: 'key'}, line, `${entry.log.name} `, el('label', {htmlFor: shift.id}, 'shift, s '), shift, away);
    }));
  }

  build() {
    this.plot?.destroy();
    this.plot = null;
    const shown = this.logs.filter(({data}) => data !== null);
    if (shown.length === 0) return;
    const quiet = colour('quiet'), axis = {stroke: quiet, grid: {stroke: colour('line'), width: 1}, ticks: {show: false}};
    const name = this.column.value, unit = shown[0].log.unit(name);
    const tables = shown.map(({data, shift}) => [shift === 0 ? data.times : data.times.map((time) => time + shift), data.values]);
    this.plot = new uPlot({
      width: Math.max(this.box.clientWidth, 100), height: 320, title: unit ? `${name} [${unit}]` : name,
      scales: {x: {time: false}}, cursor: {drag: {x: true, y: false}},
      axes: [{...axis, values: (_, all) => all.map((t) => `${Number(t.toFixed(3))} s`)}, {...axis, size: 60}],
      // A row of another file only is not a gap.
      series: [{label: 's'}, ...shown.map(({log}) => ({label: log.name, spanGaps: false, points: {show: false}, width: 1.6,
        stroke: colour(kColours[this.indexOf(log)]), dash: kDashes[this.indexOf(log)]}))],
    }, uPlot.join(tables), this.box);
  }

  indexOf(log) { return this.logs.findIndex((entry) => entry.log === log); }
}
