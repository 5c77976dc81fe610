// Before somebody drives a robot that is not in its start pose: how it stands, and three ways to go on.
import {degrees, el, number} from './dom.js';
import {PosePicture} from './pose_picture.js';
import {isSecure, poseFindings} from './start_pose.js';

export class PoseDialog {
  /// `look`: {joints, state, body} of now; `go`: take the robot.
  constructor(look, go) {
    this.look = look;
    this.go = go;
    this.canvas = el('canvas', {width: 340, height: 300, role: 'img', ariaLabel: 'The robot as it is, and beside it, orange, in its start pose'});
    this.words = el('div', {role: 'status'});
    this.retry = el('button', {type: 'button', id: 'pose-retry'}, 'Retry');
    this.on = el('button', {type: 'button', id: 'pose-go'}, 'Go on');
    this.cancel = el('button', {type: 'button', id: 'pose-cancel'}, 'Cancel');
    const title = el('h2', {id: 'pose-title'}, 'The robot is not in its start pose');
    this.node = el('dialog', {id: 'pose', 'aria-labelledby': 'pose-title'}, title,
      el('div', {className: 'pose-columns'},
        el('figure', {}, this.canvas, el('figcaption', {}, 'now, and beside it, orange, the start pose')),
        el('div', {}, this.words,
          el('p', {}, el('strong', {}, 'Retry: '), 'sit it down upright first, then look again.'),
          el('p', {}, el('strong', {}, 'Go on: '), 'take it where it is. Nothing moves until you move it; a walk then ' +
            'begins from here, slowly, a page at its own speed. Hold the robot.'))),
      el('div', {className: 'choices'}, this.retry, this.on, this.cancel));
    document.body.append(this.node);
    this.retry.addEventListener('click', () => this.ask());
    this.on.addEventListener('click', () => { this.node.close(); this.go(); });
    this.cancel.addEventListener('click', () => this.node.close());
  }

  /// Takes the robot at once when it is where it should be, or when it is held where it is anyway.
  ask() {
    const {joints, state, body} = this.look();
    const findings = state && joints.length > 0 ? poseFindings(joints, state) : null;
    if (findings !== null && (isSecure(findings) || kHeld.includes(state.state))) {
      if (this.node.open) this.node.close();
      return this.go();
    }
    this.words.replaceChildren(findings === null ? 'Nothing is heard of the robot: nobody knows how it stands.' : this.list(findings));
    if (!this.node.open) {
      this.node.showModal();
      this.retry.focus();
    }
    this.canvas.hidden = findings === null || !body || !this.draws(body, joints, state);
    return undefined;
  }

  /// Not without WebGL.
  draws(body, joints, state) {
    try {
      new PosePicture(this.canvas, body).draw(joints, state);
      return true;
    } catch {
      return false;
    }
  }

  list({off, upright}) {
    const lines = off.map(({name, by}) => el('li', {}, by === null ? `${name} does not tell where it is`
      : `${name} is ${number(Math.abs(degrees(by)), 0)}° off`));
    if (upright !== true) lines.push(el('li', {}, upright === null ? 'nobody knows whether it is upright' : 'it is not upright'));
    return el('ul', {}, ...lines);
  }
}

const kHeld = ['holding', 'driven', 'starting', 'taking_over', 'found_stiff'];
