// Torque switch of a limb, with a warning before it is switched off.
import {el, setText} from './dom.js';

export const kLimbs = [['right_arm', 'Right arm'], ['left_arm', 'Left arm'], ['head', 'Head'], ['right_leg', 'Right leg'],
  ['left_leg', 'Left leg']];

export class LimbTorque {
  constructor(steering, chain, name) {
    this.steering = steering;
    this.chain = chain;
    this.name = name;
    this.button = el('button', {type: 'button', id: `torque-${chain}`});
    this.yes = el('button', {type: 'button', className: 'danger', id: `limp-${chain}`}, `Switch torque of the ${name.toLowerCase()} off`);
    this.no = el('button', {type: 'button'}, 'Keep torque');
    this.question = el('div', {className: 'warning', role: 'alert', hidden: true},
      el('p', {}, `Without torque the ${name.toLowerCase()} falls${chain.endsWith('leg') ? ', and a standing robot with it' : ''}. ` +
        'Hold the robot first.'), this.yes, ' ', this.no);
    this.node = el('div', {className: 'torque'}, this.button, this.question);
    this.button.addEventListener('click', () => (this.limp ? steering.torque(chain, true) : this.ask()));
    this.yes.addEventListener('click', () => { steering.torque(chain, false); this.close(); });
    this.no.addEventListener('click', () => this.close());
    steering.addEventListener('change', () => this.update());
    this.update();
  }

  get limp() { return this.steering.doing.limp.includes(this.chain); }

  ask() {
    this.question.hidden = false;
    this.no.focus();
  }

  close() {
    this.question.hidden = true;
    this.button.focus();
  }

  update() {
    const {drives} = this.steering;
    this.button.disabled = !drives;
    if (!drives) this.question.hidden = true;
    setText(this.button, !this.limp ? 'Torque off …' : `${this.name} is limp${drives ? ': torque on' : ''}`);
    this.node.classList.toggle('limp', this.limp);
  }
}
