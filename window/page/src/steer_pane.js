// Steer tab: walk pad, motion pages, torque, and a slider per servo.
import {degrees, el, number, setText} from './dom.js';
import {GaitPad} from './gait_pad.js';
import {kLimbs, LimbTorque} from './limb_torque.js';
import {PageButtons} from './page_buttons.js';

export class SteerPane {
  constructor(steering) {
    this.steering = steering;
    this.note = el('p', {className: 'note'},
      'Press “Drive …” first. Then move a slider, or drag an arm, a leg or the head in the 3D view. ' +
      'Joints move at most 2 rad/s; safety limits apply as for a controller.');
    this.node = el('div', {className: 'pane'});
    this.pad = new GaitPad(steering);
    this.pages = new PageButtons(steering);
    this.rows = [];
    steering.addEventListener('change', () => this.enable());
  }

  begin(joints) {
    this.rows = joints.map((joint) => {
      const slider = el('input', {type: 'range', min: degrees(joint.low).toFixed(1), max: degrees(joint.high).toFixed(1),
        step: '0.5', id: `aim-${joint.name}`});
      const value = el('output', {}, '—');
      slider.addEventListener('input', () => this.aim(joint.name, (Number(slider.value) * Math.PI) / 180));
      return {joint, slider, value, touched: 0, known: false,
        line: el('div', {className: 'aim'}, el('label', {htmlFor: slider.id, title: joint.meaning}, joint.name), slider, value)};
    });
    this.node.replaceChildren(this.note, el('div', {className: 'moves'}, this.pad.node, this.pages.node),
      el('div', {className: 'limbs'}, ...kLimbs.map(([chain, name]) => el('fieldset', {}, el('legend', {}, name),
        new LimbTorque(this.steering, chain, name).node, ...this.rows.filter((row) => row.joint.chain === chain).map((row) => row.line)))));
    this.enable();
  }

  enable() {
    const {drives, doing} = this.steering;
    for (const row of this.rows) row.slider.disabled = !drives || !row.known || doing.limp.includes(row.joint.chain);
  }

  aim(name, angle) {
    const row = this.rows.find(({joint}) => joint.name === name);
    const within = Math.min(Math.max(angle, row.joint.low), row.joint.high);
    row.touched = performance.now();
    this.steering.aim(name, within);
    return within;
  }

  restyle() {}
  draw() {}

  /// Sliders that are not in use show the goal or the position.
  update({joints}) {
    this.rows.forEach((row, i) => {
      const is = joints.position[i], goal = joints.goal[i] ?? is;
      row.known = goal !== null;
      setText(row.value, is === null ? '—' : `${number(degrees(is), 1)}°`);
      if (goal !== null && performance.now() - row.touched > 700) row.slider.value = degrees(goal);
    });
    this.enable();
  }
}
