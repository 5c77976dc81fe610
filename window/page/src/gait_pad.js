// Walking while a button, or its key, is held; who lets go, looks elsewhere or loses the page stands.
import {el, setText} from './dom.js';

/// name, keys, where it stands on the pad, amplitudes
const kWays = [
  {id: 'turn-left', text: '↺', label: 'Turn left', key: 'q', way: {a: 1}},
  {id: 'forward', text: '▲', label: 'Forward', key: 'w', way: {x: 1}},
  {id: 'turn-right', text: '↻', label: 'Turn right', key: 'e', way: {a: -1}},
  {id: 'left', text: '◀', label: 'Step left', key: 'a', way: {y: 1}},
  {id: 'mark', text: '●', label: 'Step in place', key: 'x', way: {}},
  {id: 'right', text: '▶', label: 'Step right', key: 'd', way: {y: -1}},
  {id: 'backward', text: '▼', label: 'Backward', key: 's', way: {x: -1}},
];
const kUsualPart = 0.5;  // of the greatest amplitudes: what a beginner's floor allows

export class GaitPad {
  constructor(steering) {
    this.steering = steering;
    this.held = new Map();  // by what holds it: a way
    this.part = el('input', {type: 'range', min: '0.1', max: '1', step: '0.1', value: String(kUsualPart), id: 'gait-part'});
    this.part.addEventListener('input', () => this.tell());
    this.pad = el('div', {className: 'pad', role: 'group', ariaLabel: 'Walk while held'}, ...kWays.map((way) => this.button(way)));
    this.status = el('p', {className: 'note', role: 'status'});
    this.node = el('fieldset', {id: 'gait'}, el('legend', {}, 'Walk'), this.pad,
      el('div', {className: 'aim'}, el('label', {htmlFor: 'gait-part'}, 'Step size'), this.part), this.status);
    document.addEventListener('keydown', (event) => this.key(event, true));
    document.addEventListener('keyup', (event) => this.key(event, false));
    addEventListener('blur', () => this.release());
    steering.addEventListener('change', () => this.show());
    this.show();
  }

  button(way) {
    const button = el('button', {type: 'button', id: `go-${way.id}`, title: `${way.label} (hold; key ${way.key})`}, way.text);
    button.setAttribute('aria-label', `${way.label}, while held`);
    button.addEventListener('pointerdown', (event) => {
      button.setPointerCapture(event.pointerId);
      this.hold(`pointer ${event.pointerId}`, way);
    });
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'])
      button.addEventListener(end, (event) => this.letGo(`pointer ${event.pointerId}`));
    button.addEventListener('contextmenu', (event) => event.preventDefault());  // a long touch
    button.addEventListener('keydown', (event) => this.press(event, way, true));
    button.addEventListener('keyup', (event) => this.press(event, way, false));
    button.addEventListener('blur', () => this.letGo(`button ${way.id}`));
    way.button = button;
    return button;
  }

  // Space and Enter on a button that has the focus.
  press(event, way, down) {
    if (event.key !== ' ' && event.key !== 'Enter') return;
    event.preventDefault();
    if (down) this.hold(`button ${way.id}`, way);
    else this.letGo(`button ${way.id}`);
  }

  // Letters while the pad is seen; not while one writes, and not with Ctrl, which is the browser's.
  key(event, down) {
    const way = kWays.find(({key}) => key === event.key.toLowerCase());
    if (!way) return;
    if (!down) return this.letGo(`key ${way.key}`);
    if (!this.steering.drives || event.ctrlKey || event.altKey || event.metaKey || this.node.offsetParent === null) return;
    if (event.target.tagName === 'SELECT' || (event.target.tagName === 'INPUT' && event.target.type !== 'range')) return;
    event.preventDefault();
    event.stopImmediatePropagation();  // s would save
    this.hold(`key ${way.key}`, way);
  }

  hold(by, way) {
    if (!this.steering.drives || this.held.get(by) === way) return;
    this.held.set(by, way);
    this.tell();
  }

  letGo(by) {
    if (this.held.delete(by)) this.tell();
  }

  release() {
    if (this.held.size === 0) return;
    this.held.clear();
    this.tell();
  }

  /// What is held together adds up.
  tell() {
    const part = Number(this.part.value), walk = {x: 0, y: 0, a: 0};
    for (const {way} of this.held.values())
      for (const axis of Object.keys(way)) walk[axis] = Math.min(Math.max(walk[axis] + way[axis] * part, -1), 1);
    this.steering.go(this.held.size > 0 ? walk : null);
    this.show();
  }

  show() {
    const {drives, doing} = this.steering;
    if (!drives) this.held.clear();
    const held = new Set(this.held.values());
    for (const way of kWays) {
      way.button.disabled = !drives || doing.page !== 0;
      way.button.classList.toggle('held', held.has(way));
    }
    setText(this.status, !drives ? 'Hold a button, or its key, to walk; let go to end.' : doing.walks ? 'Walking'
      : doing.page !== 0 ? 'A page is played' : 'It holds still');
  }
}
