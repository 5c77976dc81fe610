// Driving status, Drive and STOP buttons.
import {el, setText} from './dom.js';

export class SteerBar {
  /// `take` is called when the user presses Drive.
  constructor(node, steering, take) {
    this.steering = steering;
    this.take = el('button', {type: 'button', id: 'take'}, 'Drive …');
    this.stop = el('button', {type: 'button', id: 'stop'}, 'STOP');
    this.stop.title = 'Hold the robot in its present pose and stop driving (Escape)';
    this.status = el('span', {role: 'status'});
    node.append(this.status, this.take, this.stop);
    this.take.addEventListener('click', () => take());
    this.stop.addEventListener('click', () => steering.stop());
    document.addEventListener('keydown', (event) => event.key === 'Escape' && steering.stop());
    steering.addEventListener('change', () => this.update());
    this.update();
  }

  update() {
    const {drives, asking, ending, text, doing} = this.steering;
    document.body.classList.toggle('driving', drives);
    this.take.hidden = drives || asking || ending;
    setText(this.status, drives ? `You are driving${doing.refused ? `; refused: ${doing.refused}` : ''}` : text);
  }
}
