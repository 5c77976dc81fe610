// Panes behind tabs, as the ARIA practices have them: arrow keys walk, Home and End jump. They are one row, which scrolls
// sideways where it is too narrow.
import {el} from './dom.js';

const kPeek_px = 40;  // so much of the neighbour is seen, too

export class Tabs {
  /// panes: [{name, pane}]; `chosen` is told the pane that is shown.
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

  /// The chosen tab; sideways only, the page stays where it is.
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

  /// A red number on a tab; 0: none.
  count(i, number) {
    const {tab, name} = this.panes[i];
    tab.replaceChildren(name, ...(number > 0 ? [el('span', {className: 'count'}, String(number))] : []));
  }
}
