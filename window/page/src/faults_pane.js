// Faults tab: active faults with remedies, and recent notices.
import {el, number} from './dom.js';

const kKept = 50;

export class FaultsPane {
  constructor(taken) {
    this.taken = taken;  // called with the active faults
    this.active = el('div', {}, el('p', {}, '—'));
    this.list = el('ol', {className: 'notices', reversed: true});
    this.numbers = new Set();
    this.node = el('div', {className: 'pane'}, el('div', {ariaLive: 'polite'}, el('h3', {}, 'Active'), this.active),
      el('div', {}, el('h3', {}, 'Recent'), this.list));
  }

  begin() {}
  restyle() {}
  draw() {}
  update() {}

  forget() {
    this.numbers.clear();
    this.list.replaceChildren();
  }

  /// A "faults" message: all active faults.
  take({active}) {
    this.taken(active);
    if (active.length === 0) return this.active.replaceChildren(el('p', {}, 'No faults.'));
    return this.active.replaceChildren(...active.map((fault) => el('div', {className: 'fault'},
      el('p', {}, el('strong', {}, `${fault.name}${fault.joint ? `, ${fault.joint}` : ''}`), ` (${fault.code})`),
      el('p', {}, `${fault.meaning}.`), el('p', {}, el('strong', {}, 'Remedy: '), `${fault.remedy}.`))));
  }

  notice({number: n, time, text}) {
    if (this.numbers.has(n)) return;  // repeated after a reconnect
    this.numbers.add(n);
    this.list.prepend(el('li', {}, el('time', {}, time === null ? '—' : `${number(time, 1)} s`), el('span', {}, text)));
    while (this.list.children.length > kKept) this.list.lastChild.remove();
    if (this.numbers.size > 10 * kKept) this.numbers = new Set([...this.numbers].slice(-kKept));
  }
}
