// Status bar: state, battery, faults, loop.
import {el, number, setClass, setText, withUnit} from './dom.js';

const kStates = {
  offline: ['offline', 'bad'], limp: ['limp', ''], taking_over: ['taking over', ''], starting: ['going to start pose', ''],
  driven: ['driven', ''], holding: ['holding', ''], kneeling: ['kneeling', 'warn'], found_stiff: ['torque on, not driven', 'warn'],
};
const kLow = 11.0, kEmpty = 10.0;  // V, faults 20 and 21

export class Pills {
  constructor(list) {
    this.parts = {};
    for (const name of ['State', 'Battery', 'Faults', 'Overruns', 'Rate']) {
      const value = el('span', {}, '—'), item = el('li', {}, el('span', {className: 'name'}, name), value);
      this.parts[name] = {value, item};
      list.append(item);
    }
  }

  set(name, text, look = '') {
    setText(this.parts[name].value, text);
    setClass(this.parts[name].item, look);
  }

  state(state, rate) {
    const [words, look] = kStates[state.state] ?? [state.state, ''];
    this.set('State', words, look);
    const volts = state.board.voltage;
    this.set('Battery', withUnit(volts, 1, 'V'), volts !== null && volts < kEmpty ? 'bad' : volts !== null && volts < kLow ? 'warn' : '');
    this.set('Rate', withUnit(rate, 0, 'states/s'));
  }

  loop(message) {
    const recent = message.recent?.overruns;
    this.set('Overruns', number(message.overruns), recent > 0 ? 'warn' : '');
  }

  faults(count) { this.set('Faults', count === 0 ? 'none' : String(count), count > 0 ? 'bad' : ''); }

  nothing() {
    for (const name of Object.keys(this.parts)) this.set(name, '—');
  }
}
