// Status bar: state, battery, faults, loop.
import {batteryLook} from './battery.js';
import {el, number, setClass, setText, withUnit} from './dom.js';

const kStates = {
  offline: ['offline', 'bad'], limp: ['limp', ''], taking_over: ['taking over', ''], starting: ['going to start pose', ''],
  driven: ['driven', ''], holding: ['holding', ''], kneeling: ['kneeling', 'warn'], found_stiff: ['torque on, not driven', 'warn'],
};

export class Pills {
  constructor(list) {
    this.parts = {};
    this.battery = '';
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
    this.set('Battery', withUnit(state.board.voltage, 1, 'V'), this.battery);
    this.set('Rate', withUnit(rate, 0, 'states/s'));
  }

  loop(message) {
    const recent = message.recent?.overruns;
    this.set('Overruns', number(message.overruns), recent > 0 ? 'warn' : '');
  }

  /// All active faults.
  faults(active) {
    this.battery = batteryLook(active);
    this.set('Faults', active.length === 0 ? 'none' : String(active.length), active.length > 0 ? 'bad' : '');
  }

  nothing() {
    for (const name of Object.keys(this.parts)) this.set(name, '—');
  }
}
