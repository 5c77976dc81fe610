// Panes behind tabs, as the ARIA practices have them: arrow keys walk, Home and End jump.
import {el} from './dom.js';

export class Tabs {
  /// panes: [{name, pane}]; `chosen` is told the pane that is shown.
  constructor(list, stage, panes, chosen) {
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
  }

  show(i) {
    this.current = i;
    this.panes.forEach(({tab, pane}, n) => {
      tab.setAttribute('aria-selected', String(n === i));
      tab.tabIndex = n === i ? 0 : -1;
      pane.node.hidden = n !== i;
      if (n !== i) pane.shown?.(false);
    });
    this.panes[i].pane.shown?.(true);
    this.chosen(this.panes[i].pane);
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
