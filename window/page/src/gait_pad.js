// Walk pad: walks while a button or key is held; stops on release, loss of focus or loss of the connection.
import {el, setText} from './dom.js';
import {kStandingStill} from './messages.js';

/// In the order of the pad; `way`: amplitudes.
const kDirections = [
  {id: 'turn-left', text: '↺', label: 'Turn left', key: 'q', way: {a: 1}},
  {id: 'forward', text: '▲', label: 'Forward', key: 'w', way: {x: 1}},
  {id: 'turn-right', text: '↻', label: 'Turn right', key: 'e', way: {a: -1}},
  {id: 'left', text: '◀', label: 'Step left', key: 'a', way: {y: 1}},
  {id: 'mark', text: '●', label: 'Step in place', key: 'x', way: {}},
  {id: 'right', text: '▶', label: 'Step right', key: 'd', way: {y: -1}},
  {id: 'backward', text: '▼', label: 'Backward', key: 's', way: {x: -1}},
];
const kUsualPart = 0.5;  // of the maximum amplitudes

export class GaitPad {
  constructor(steering) {
    this.steering = steering;
    this.held = new Map();  // direction by input source
    this.part = el('input', {type: 'range', min: '0.1', max: '1', step: '0.1', value: String(kUsualPart), id: 'gait-part'});
    this.part.addEventListener('input', () => this.update());
    this.pad = el('div', {className: 'pad', role: 'group', ariaLabel: 'Walk while held'}, ...kDirections.map((way) => this.button(way)));
    this.status = el('p', {className: 'note', role: 'status'});
    this.node = el('fieldset', {id: 'gait'}, el('legend', {}, 'Walk'), this.pad,
      el('div', {className: 'aim'}, el('label', {htmlFor: 'gait-part'}, 'Step size'), this.part), this.status);
    document.addEventListener('keydown', (event) => this.key(event, true));
    document.addEventListener('keyup', (event) => this.key(event, false));
    addEventListener('blur', () => this.releaseAll());
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
      button.addEventListener(end, (event) => this.releaseOne(`pointer ${event.pointerId}`));
    button.addEventListener('contextmenu', (event) => event.preventDefault());  // long touch
    button.addEventListener('keydown', (event) => this.press(event, way, true));
    button.addEventListener('keyup', (event) => this.press(event, way, false));
    button.addEventListener('blur', () => this.releaseOne(`button ${way.id}`));
    way.button = button;
    return button;
  }

  // Space and Enter on a focused button.
  press(event, way, down) {
    if (event.key !== ' ' && event.key !== 'Enter') return;
    event.preventDefault();
    if (down) this.hold(`button ${way.id}`, way);
    else this.releaseOne(`button ${way.id}`);
  }

  // Letter keys while the pad is visible; not in text fields and not with Ctrl.
  key(event, down) {
    const way = kDirections.find(({key}) => key === event.key.toLowerCase());
    if (!way) return;
    if (!down) return this.releaseOne(`key ${way.key}`);
    if (!this.steering.drives || event.ctrlKey || event.altKey || event.metaKey || this.node.offsetParent === null) return;
    if (event.target.tagName === 'SELECT' || (event.target.tagName === 'INPUT' && event.target.type !== 'range')) return;
    event.preventDefault();
    event.stopImmediatePropagation();  // s would also save
    this.hold(`key ${way.key}`, way);
  }

  hold(by, way) {
    if (!this.steering.drives || this.held.get(by) === way) return;
    this.held.set(by, way);
    this.update();
  }

  releaseOne(by) {
    if (this.held.delete(by)) this.update();
  }

  releaseAll() {
    if (this.held.size === 0) return;
    this.held.clear();
    this.update();
  }

  /// Adds up all held directions.
  update() {
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
    for (const way of kDirections) {
      way.button.disabled = !drives || doing.page !== 0;
      way.button.classList.toggle('held', held.has(way));
    }
    setText(this.status, !drives ? 'Hold a button or its key to walk; release it to stop.' : doing.walks ? 'Walking'
      : doing.page !== 0 ? 'Playing a motion page' : kStandingStill);
  }
}
