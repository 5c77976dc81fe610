// Controls of the colour search. Settings are stored in the page only.
import {el, setText} from './dom.js';
import {codeOf, kBalls, kSettings} from './search_text.js';

export class ColourSearch {
  /// `changed` is called after each change.
  constructor(changed) {
    this.changed = changed;
    this.settings = {...kBalls['Orange ball']};
    this.looks = el('input', {type: 'checkbox', id: 'look-for', checked: true});
    this.tints = el('input', {type: 'checkbox', id: 'tint', checked: true});
    this.band = el('div', {className: 'hues', role: 'img'});
    this.code = el('code', {id: 'vision-code'});
    this.copied = el('span', {className: 'note', role: 'status'});
    this.inputs = new Map(kSettings.map((setting) => [setting.name, this.slider(setting)]));
    for (const box of [this.looks, this.tints]) box.addEventListener('change', () => this.update());
    const rows = [...this.inputs.values()].map(({row}) => row);
    this.node = el('fieldset', {className: 'search'}, el('legend', {}, 'Colour of the ball'),
      el('div', {className: 'choose'}, el('label', {}, this.looks, ' search'), el('label', {}, this.tints, ' highlight pixels'),
        ...Object.keys(kBalls).map((name) => this.ball(name))),
      el('p', {className: 'note'}, 'Click on the ball in the picture to take its hue.'), this.band, ...rows,
      el('p', {className: 'note'}, 'For a controller:'), el('pre', {}, this.code),
      el('div', {className: 'choose'}, this.copyButton(), this.copied));
    this.show();
  }

  /// Request for the channel; null: no search.
  get request() { return this.looks.checked ? {...this.settings, mask: this.tints.checked} : null; }

  slider({name, text, least, most, unit}) {
    const input = el('input', {type: 'range', id: `vision-${name}`, min: least, max: most, step: 1});
    const value = el('output', {}), label = el('label', {}, text);
    label.htmlFor = input.id;
    input.addEventListener('input', () => this.set({[name]: Number(input.value)}));
    return {input, value, unit, row: el('div', {className: 'aim'}, label, input, value)};
  }

  ball(name) {
    const button = el('button', {type: 'button'}, name);
    button.addEventListener('click', () => this.set(kBalls[name]));
    return button;
  }

  copyButton() {
    const button = el('button', {type: 'button', id: 'copy-code'}, 'Copy');
    button.addEventListener('click', () => navigator.clipboard.writeText(this.code.textContent).then(
      () => setText(this.copied, 'Copied.'), () => setText(this.copied, 'The browser denied access to the clipboard; select the line and copy it.')));
    return button;
  }

  set(some) {
    Object.assign(this.settings, some);
    this.update();
  }

  update() {
    this.show();
    this.changed();
  }

  show() {
    for (const [name, {input, value, unit}] of this.inputs) {
      const now = this.settings[name], text = now < 0 ? 'any' : `${now} ${unit}`;
      if (Number(input.value) !== now) input.value = String(now);
      input.setAttribute('aria-valuetext', text);
      setText(value, text);
    }
    const {hue, hueTolerance} = this.settings;
    const hues = [-1, -0.5, 0, 0.5, 1].map((part) => `hsl(${hue + part * hueTolerance} 90% 50%)`);
    this.band.style.background = `linear-gradient(to right, ${hues.join(', ')})`;
    this.band.ariaLabel = `Hues from ${(hue - hueTolerance + 360) % 360} to ${(hue + hueTolerance) % 360} degrees`;
    setText(this.code, codeOf(this.settings));
    setText(this.copied, '');
  }
}
