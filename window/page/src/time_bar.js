// Pause, time range, zoom and CSV export of all plots.
import {csvOf, save} from './csv.js';
import {el, setText} from './dom.js';
import {kLengths} from './timeline.js';

export class TimeBar {
  constructor(node, timeline, fileName) {
    this.timeline = timeline;
    this.pause = this.button('Pause', () => (timeline.paused ? timeline.resume() : timeline.pause()), 'p');
    this.length = el('select', {ariaLabel: 'Seconds shown'},
      ...kLengths.map((s) => el('option', {value: String(s), selected: s === timeline.length}, s < 60 ? `${s} s` : `${s / 60} min`)));
    this.length.addEventListener('change', () => timeline.setLength(Number(this.length.value)));
    this.zooms = [this.button('+', () => timeline.scale(0.5), '', 'Zoom in'),
      this.button('−', () => timeline.scale(2), '', 'Zoom out'),
      this.button('◀', () => timeline.shift(-0.25), '', 'Earlier'), this.button('▶', () => timeline.shift(0.25), '', 'Later')];
    this.export = this.button('Save CSV', () => timeline.range && save(csvOf(timeline.store, timeline.range), fileName()), 's');
    node.append(this.pause, this.length, ...this.zooms, this.export);
    timeline.addEventListener('change', () => this.update());
    document.addEventListener('keydown', (event) => this.key(event));
    this.update();
  }

  button(text, act, key = '', label = '') {
    const button = el('button', {type: 'button'}, text);
    if (label) button.setAttribute('aria-label', label);
    if (label || key) button.title = `${label || text}${key ? ` (key ${key})` : ''}`;
    button.addEventListener('click', act);
    return button;
  }

  update() {
    setText(this.pause, this.timeline.paused ? 'Go on' : 'Pause');
    this.pause.setAttribute('aria-pressed', String(this.timeline.paused));
  }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || ['INPUT', 'SELECT'].includes(event.target.tagName)) return;
    if (event.key === 'p') this.pause.click();
    else if (event.key === 's') this.export.click();
    else if (event.key === 'Escape') this.timeline.resume();
  }
}
