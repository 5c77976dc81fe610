// Live comparison of the robot with its twin: model, what holds the trunk, residuals as they arrive.
import {el, setText} from './dom.js';
import {LiveTable} from './live_table.js';
import {kSupportNotes, kSupports, lossText, stateText} from './live_text.js';

const kStep_mrad = 2 * Math.PI / 4096 * 1000;  // of the encoder
const kOpen_mrad = 2 * kStep_mrad;             // a joint agrees within two steps
const kAxes = ['x', 'y', 'z'];
const fileOf = (model) => model.split('/').pop();

export class LivePane {
  /// `tint`: colours joints in the view, by a map of name to share of disagreement (0 agrees, 1), or null.
  constructor(live, tint) {
    this.live = live;
    this.tint = tint;
    this.joints = [];
    this.compared = '';  // what the curves show
    this.model = el('input', {type: 'text', id: 'live-model', size: 28, spellcheck: false, maxLength: 900});
    this.support = el('select', {id: 'live-support'}, ...Object.entries(kSupports).map(([value, text]) => el('option', {value}, text)));
    this.start = el('button', {type: 'button', id: 'live-start'}, 'Start');
    this.stop = el('button', {type: 'button', id: 'live-stop', disabled: true}, 'Stop');
    this.status = el('p', {className: 'note', role: 'status', id: 'live-status'});
    this.loss = el('p', {className: 'note', id: 'live-loss'});
    this.note = el('p', {className: 'note'}, kSupportNotes.clamped);
    this.before = el('p', {className: 'note', id: 'live-before'});
    this.table = new LiveTable('Joint', [
      {key: 'position_mrad', title: 'Position', unit: 'mrad', digits: 2, least: 5, open: kOpen_mrad},
      {key: 'load_percent', title: 'Load', unit: '% of maximum torque', digits: 1, least: 5, open: Infinity}], 'Residuals of the joints');
    this.sensors = new LiveTable('Axis', [
      {key: 'gyro_rad_s', title: 'Gyro', unit: 'rad/s', digits: 3, least: 0.1, open: Infinity},
      {key: 'accelerometer_m_s2', title: 'Accelerometer', unit: 'm/s²', digits: 2, least: 0.5, open: Infinity}], 'Residuals of the motion sensors');
    this.sensors.begin(kAxes);
    this.node = el('section', {className: 'pane live', ariaLabel: 'Live comparison'},
      el('h2', {}, 'Live: robot minus twin'),
      el('p', {className: 'note'}, 'A twin runs beside the robot on the same commands. It never moves the robot. A model is a name (darwin-op) or an INI file on this computer, such as darwinop gap add writes.'),
      el('div', {className: 'choose'}, el('label', {htmlFor: 'live-model'}, 'Model'), this.model,
        el('label', {htmlFor: 'live-support'}, 'Twin'), this.support, this.start, this.stop),
      this.note, this.status, this.loss, this.before, this.table.node, this.sensors.node);
    this.start.addEventListener('click', () => this.begins());
    this.model.addEventListener('keydown', (event) => { if (event.key === 'Enter') this.begins(); });
    this.stop.addEventListener('click', () => live.stop());
    this.support.addEventListener('change', () => {
      setText(this.note, kSupportNotes[this.support.value]);
      if (live.state?.runs) this.begins();
    });
    live.addEventListener('change', () => this.take());
    live.addEventListener('refused', ({detail}) => setText(this.status, detail));
    this.take();
  }

  begin(joints) {
    this.joints = joints.map(({name}) => name);
    this.table.begin(this.joints);
    this.take();
  }

  shown(is_shown) {
    this.is_shown = is_shown;
    this.colour();
  }

  begins() {
    if (this.model.value.trim()) this.live.run(this.model.value.trim(), this.support.value);
  }

  take() {
    const {state} = this.live, signals = state?.signals ?? null;
    if (state !== null && this.model.value === '') this.model.value = state.setting.model;
    setText(this.start, state?.runs ? 'Restart' : 'Start');
    this.start.disabled = state === null;
    this.stop.disabled = !state?.runs;
    setText(this.status, `${state?.runs ? `${fileOf(state.setting.model)}, ${kSupports[state.setting.support].toLowerCase()}. ` : ''}${stateText(state)}`);
    setText(this.loss, lossText(state));
    const before = state?.before ?? null;
    setText(this.before, before ? `Before: ${fileOf(before.model)}, ${kSupports[before.support].toLowerCase()}.` : '');
    const compared = state?.runs ? `${state.setting.model} ${state.setting.support}` : '';
    const mark = compared !== this.compared && this.compared !== '' && compared !== '';
    this.compared = compared;
    if (state?.runs || mark) {
      this.table.take(signals, before?.signals, mark);
      this.sensors.take(signals, before?.signals, mark);
    }
    this.table.node.hidden = this.sensors.node.hidden = !state?.runs && !state?.cycles;
    this.colour();
  }

  /// Gives the view its own colours back only if they are ours.
  colour() {
    const {state} = this.live, rms = state?.signals.position_mrad.rms, tints = Boolean(this.is_shown && state?.runs && rms);
    if (tints) this.tint(new Map(this.joints.map((name, i) => [name, rms[i] === null ? null : Math.min(rms[i] / kOpen_mrad, 1)])));
    else if (this.tints) this.tint(null);
    this.tints = tints;
  }
}
