// "You are driving", so that nobody can miss it, and the stop beside it.
import {el, setText} from './dom.js';

export class SteerBar {
  /// `take`: somebody wants to drive.
  constructor(node, steering, take) {
    this.steering = steering;
    this.take = el('button', {type: 'button', id: 'take'}, 'Drive …');
    this.stop = el('button', {type: 'button', id: 'stop'}, 'STOP');
    this.stop.title = 'The robot holds where it is, and you no longer drive (key Escape)';
    this.words = el('span', {role: 'status'});
    node.append(this.words, this.take, this.stop);
    this.take.addEventListener('click', () => take());
    this.stop.addEventListener('click', () => steering.stop());
    document.addEventListener('keydown', (event) => event.key === 'Escape' && steering.stop());
    steering.addEventListener('change', () => this.tell());
    this.tell();
  }

  tell() {
    const {drives, asking, text, doing} = this.steering;
    document.body.classList.toggle('driving', drives);
    this.take.hidden = drives || asking;
    this.stop.disabled = !drives && !asking;
    setText(this.words, drives ? `You are driving${doing.refused ? `; refused: ${doing.refused}` : ''}` : text);
  }
}
