// Servos tab: findings of the doctor, curves of one servo, table of all.
import {CurvePlot} from './curve_plot.js';
import {DoctorPanel} from './doctor_panel.js';
import {degrees, el, number, setClass, setText} from './dom.js';
import {kServoHot} from './limits.js';

const kWarm = 55;  // deg C
const kHead = [['Servo', ''], ['Target', 'deg'], ['Actual', 'deg'], ['Error', 'deg'], ['Load', '%'], ['Temperature', '°C'],
  ['Supply', 'V'], ['Torque', ''], ['Age', 'cycles']];
const kDegrees = 180 / Math.PI;

export class ServosPane {
  constructor(timeline, doctor) {
    this.timeline = timeline;
    this.timed = true;
    this.doctor = new DoctorPanel(doctor);  // also without a runtime, when there is nothing else
    this.node = el('div', {className: 'pane'}, this.doctor.node);
    this.rows = [];
    this.chosen = 0;
  }

  /// The joints of "hello".
  begin(joints) {
    this.joints = joints;
    const curves = this.curvesOf(joints[this.chosen]);
    const make = (i, title, unit, height, digits, span) =>
      new CurvePlot(this.timeline, {title, unit, curves: curves[i], height, digits, span, least: 2});
    this.plots = [make(0, '', 'deg', 190, 2), make(1, 'Load', '% of maximum torque', 115, 0, [-10, 10]),
      make(2, 'Temperature', '°C', 95, 0, [20, 40])];
    this.body = el('tbody');
    this.rows = joints.map((joint, i) => {
      const name = el('button', {type: 'button', title: joint.meaning}, joint.name);
      name.addEventListener('click', () => this.choose(i));
      const cells = kHead.slice(1).map(() => el('td', {}, '—'));
      this.body.append(el('tr', {}, el('td', {}, name), ...cells));
      return {name, cells};
    });
    const head = kHead.map(([name, unit]) => el('th', {scope: 'col'}, name, ' ', el('span', {className: 'unit'}, unit)));
    this.node.replaceChildren(this.doctor.node, ...this.plots.map((plot) => plot.node),
      el('div', {className: 'scroll', tabIndex: 0, role: 'region', ariaLabel: 'All servos'},
        el('table', {}, el('thead', {}, el('tr', {}, ...head)), this.body)));
    this.choose(this.chosen);
  }

  curvesOf({name}) {
    return [
      [{key: `${name}.goal`, name: 'target', colour: 'target', scale: kDegrees},
        {key: `${name}.position`, name: 'actual', colour: 'actual', scale: kDegrees}],
      [{key: `${name}.load`, name: 'load', colour: 'actual', scale: 100}],
      [{key: `${name}.temperature`, name: 'temperature', colour: 'third'}],
    ];
  }

  choose(i) {
    this.chosen = i;
    this.rows.forEach(({name}, n) => name.setAttribute('aria-pressed', String(n === i)));
    const joint = this.joints[i], curves = this.curvesOf(joint);
    this.plots[0].show(curves[0], `${joint.name}, ${joint.meaning}`);
    this.plots[1].show(curves[1]);
    this.plots[2].show(curves[2]);
    this.draw();
  }

  restyle() { this.plots?.forEach((plot, i) => plot.show(this.curvesOf(this.joints[this.chosen])[i])); }
  draw() { this.plots?.forEach((plot) => plot.draw()); }

  /// Updates the table with the newest state.
  update(state) {
    const j = state.joints;
    this.rows.forEach(({cells}, i) => {
      const goal = j.goal[i], is = j.position[i];
      const error = goal === null || is === null ? null : degrees(goal - is);
      const load = j.load[i] === null ? null : 100 * j.load[i], heat = j.temperature[i];
      const torque = j.torque[i] === null ? '—' : j.torque[i] ? 'on' : 'off';
      const shut_off = j.torque_limit[i] === 0;
      [number(goal === null ? null : degrees(goal), 1), number(is === null ? null : degrees(is), 1), number(error, 1),
        number(load), number(heat), number(j.voltage[i], 1), shut_off ? 'shut off' : torque,
        j.silent[i] ? 'silent' : number(j.age[i])].forEach((text, c) => setText(cells[c], text));
      setClass(cells[4], heat >= kServoHot ? 'bad' : heat >= kWarm ? 'warn' : '');
      setClass(cells[6], shut_off ? 'bad' : '');
      setClass(cells[7], j.silent[i] ? 'bad' : '');
    });
  }
}
