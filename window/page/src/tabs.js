// Tabs according to the ARIA practices: arrow keys, Home and End. One row that scrolls horizontally.
import {el} from './dom.js';

const kPeek_px = 40;  // visible part of the neighbouring tab

export class Tabs {
  /// panes: [{name, pane}]; `chosen` is called with the pane shown.
  constructor(list, stage, panes, chosen) {
    this.list = list;
    this.panes = panes;
    this.chosen = chosen;
    panes.forEach((entry, i) => {
      entry.tab = el('button', {type: 'button', role: 'tab', id: `tab-${i}`}, entry.name);
      entry.tab.setAttribute('aria-controls', `pane-${i}`);
      entry.tab.addEventListener('click', () => this.show(i));
      entry.pane.node.id = `pane-${i}`;
      entry.pane.node.setAttribute('role', 'tabpanel');
      entry.pane.node.setAttribute('aria-labelledby', `tab-${i}`);
      list.append(entry.tab);
      stage.append(entry.pane.node);
    });
    list.addEventListener('keydown', (event) => this.key(event));
    this.show(0);
    new ResizeObserver(() => this.reveal()).observe(list);
  }

  show(i) {
    this.current = i;
    this.panes.forEach(({tab, pane}, n) => {
      tab.setAttribute('aria-selected', String(n === i));
      tab.tabIndex = n === i ? 0 : -1;
      pane.node.hidden = n !== i;
      if (n !== i) pane.shown?.(false);
    });
    this.reveal();
    this.panes[i].pane.shown?.(true);
    this.chosen(this.panes[i].pane);
  }

  /// Scrolls horizontally to the selected tab.
  reveal() {
    const {list} = this, row = list.getBoundingClientRect(), tab = this.panes[this.current].tab.getBoundingClientRect();
    if (tab.left < row.left) list.scrollLeft += tab.left - row.left - kPeek_px;
    else if (tab.right > row.right) list.scrollLeft += tab.right - row.right + kPeek_px;
  }

  key(event) {
    const last = this.panes.length - 1;
    const to = {ArrowRight: this.current === last ? 0 : this.current + 1,
      ArrowLeft: this.current === 0 ? last : this.current - 1, Home: 0, End: last}[event.key];
    if (to === undefined) return;
    event.preventDefault();
    this.show(to);
    this.panes[to].tab.focus();
  }

  /// Badge with a number on a tab; 0: none.
  count(i, number) {
    const {tab, name} = this.panes[i];
    tab.replaceChildren(name, ...(number > 0 ? [el('span', {className: 'count'}, String(number))] : []));
  }
}
