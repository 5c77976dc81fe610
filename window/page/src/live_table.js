// Table of residuals: rms, worst and the rms before, of joints or of a sensor's axes.
import {el, number, setClass, setText} from './dom.js';
import {SparkLine} from './spark_line.js';

export class LiveTable {
  /// `first`: title of the first column. `groups`: [{key of the message, title, unit, digits, least, open}]; `open`: an
  /// rms above it is marked.
  constructor(first, groups, label) {
    this.groups = groups;
    this.body = el('tbody');
    const wide = groups.map(({title, unit}) => el('th', {scope: 'colgroup', colSpan: 4}, title, ' ', el('span', {className: 'unit'}, unit)));
    const narrow = groups.flatMap(() => ['rms', 'worst', 'before', 'last minute'].map((name) => el('th', {scope: 'col'}, name)));
    this.node = el('div', {className: 'scroll', tabIndex: 0, role: 'region', ariaLabel: label},
      el('table', {}, el('thead', {}, el('tr', {}, el('th', {scope: 'col', rowSpan: 2}, first), ...wide), el('tr', {}, ...narrow)), this.body));
    this.rows = [];
  }

  begin(names) {
    this.rows = names.map((name) => this.groups.map(({least}) => {
      const line = new SparkLine(least);
      return {line, cells: [0, 1, 2].map(() => el('td', {}, '—'))};
    }));
    this.body.replaceChildren(...names.map((name, i) => el('tr', {}, el('td', {}, name),
      ...this.rows[i].flatMap(({cells, line}) => [...cells, el('td', {}, line.node)]))));
  }

  /// `signals`, `before`: of the message; null: none. `mark`: what is compared has just changed.
  take(signals, before, mark) {
    const is_visible = this.node.offsetParent !== null;  // read before the writes: each read after one causes a layout
    this.groups.forEach(({key, digits, open}, g) => {
      const now = signals?.[key], then = before?.[key];
      this.rows.forEach((row, i) => {
        const {cells, line} = row[g], rms = now?.rms[i] ?? null;
        setText(cells[0], number(rms, digits));
        setText(cells[1], number(now?.worst[i], digits));
        setText(cells[2], number(then?.rms[i], digits));
        setClass(cells[0], rms !== null && rms > open ? 'bad' : '');
        line.add(rms, mark);
        if (is_visible) line.draw();
      });
    });
  }
}
