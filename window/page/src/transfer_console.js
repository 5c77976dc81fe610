// Console: output of installer, robot and controller. Follows the end unless scrolled up.
import {el, setText} from './dom.js';

const kMostLines = 2000, kNearEnd_px = 30;
const kMarks = {error: ['✖', 'error'], warning: ['⚠', 'warning'], command: ['$', 'command']};

export class TransferConsole {
  constructor() {
    this.box = el('div', {className: 'console', id: 'transfer-console', role: 'region', tabIndex: 0, ariaLabel: 'Console'});
    this.note = el('span', {className: 'note', role: 'status'});
    const copy = el('button', {type: 'button'}, 'Copy'), save = el('button', {type: 'button'}, 'Save');
    const empty = el('button', {type: 'button'}, 'Clear');
    copy.addEventListener('click', () => this.copy());
    save.addEventListener('click', () => this.save());
    empty.addEventListener('click', () => this.box.replaceChildren());
    this.node = el('section', {ariaLabel: 'Output'},
      el('div', {className: 'choose'}, el('h3', {}, 'Console'), copy, save, empty, this.note), this.box);
  }

  add({lines, missing}) {
    const {box} = this, follows = box.scrollHeight - box.scrollTop - box.clientHeight < kNearEnd_px;
    const fresh = lines.slice(-kMostLines).map(([kind, text]) => this.line(kind, text));
    if (missing > 0) fresh.unshift(el('div', {className: 'said'}, `… ${missing} lines omitted`));
    box.append(...fresh);
    while (box.childElementCount > kMostLines) box.firstElementChild.remove();
    if (follows) box.scrollTop = box.scrollHeight;
  }

  line(kind, text) {
    const mark = kMarks[kind];
    return el('div', {className: kind}, ...(mark ? [el('span', {className: 'mark', role: 'img', ariaLabel: mark[1]}, mark[0])] : []), text);
  }

  /// Scrolls to the end, because hidden elements cannot be scrolled.
  shown() { this.box.scrollTop = this.box.scrollHeight; }

  text() {
    return [...this.box.children].map((line) => `${line.textContent}\n`).join('');
  }

  copy() {
    navigator.clipboard.writeText(this.text()).then(() => setText(this.note, 'copied'),
      () => setText(this.note, 'the browser denied access to the clipboard; use Save'));
  }

  save() {
    const url = URL.createObjectURL(new Blob([this.text()], {type: 'text/plain'}));
    el('a', {href: url, download: `darwinop-install-${new Date().toISOString().slice(0, 19).replace(/[:T]/g, '-')}.log`}).click();
    setTimeout(() => URL.revokeObjectURL(url), 1000);
  }
}
