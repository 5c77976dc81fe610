// Dialog before a takeover of a robot that is not in its start pose.
import {degrees, el, number} from './dom.js';
import {kNoData, kPoseUnknown} from './messages.js';
import {PosePicture} from './pose_picture.js';
import {isSecure, poseFindings} from './start_pose.js';

export class PoseDialog {
  /// `look` returns the present {joints, state, body}; `go` starts driving.
  constructor(look, go) {
    this.look = look;
    this.go = go;
    this.canvas = el('canvas', {width: 340, height: 300, role: 'img', ariaLabel: 'The robot now and, in orange, in its start pose'});
    this.status = el('div', {role: 'status'});
    this.retry = el('button', {type: 'button', id: 'pose-retry'}, 'Retry');
    this.on = el('button', {type: 'button', id: 'pose-go'}, 'Go on');
    this.cancel = el('button', {type: 'button', id: 'pose-cancel'}, 'Cancel');
    const title = el('h2', {id: 'pose-title'}, 'The robot is not in its start pose');
    this.node = el('dialog', {id: 'pose', 'aria-labelledby': 'pose-title'}, title,
      el('div', {className: 'pose-columns'},
        el('figure', {}, this.canvas, el('figcaption', {}, 'now; orange: start pose')),
        el('div', {}, this.status,
          el('p', {}, el('strong', {}, 'Retry: '), 'put the robot into its start pose, then check again.'),
          el('p', {}, el('strong', {}, 'Go on: '), 'drive from the present pose. Nothing moves until you move it; a walk ' +
            'starts slowly from here, a motion page at its own speed. Hold the robot.'))),
      el('div', {className: 'choices'}, this.retry, this.on, this.cancel));
    document.body.append(this.node);
    this.retry.addEventListener('click', () => this.ask());
    this.on.addEventListener('click', () => { this.node.close(); this.go(); });
    this.cancel.addEventListener('click', () => this.node.close());
  }

  /// Starts driving at once if the robot is in its start pose or under torque.
  ask() {
    const {joints, state, body} = this.look();
    const findings = state && joints.length > 0 ? poseFindings(joints, state) : null;
    if (findings !== null && (isSecure(findings) || kHeld.includes(state.state))) {
      if (this.node.open) this.node.close();
      return this.go();
    }
    this.status.replaceChildren(findings === null ? `${kNoData}: ${kPoseUnknown}.` : this.list(findings));
    if (!this.node.open) {
      this.node.showModal();
      this.retry.focus();
    }
    this.canvas.hidden = findings === null || !body || !this.draws(body, joints, state);
    return undefined;
  }

  /// False without WebGL.
  draws(body, joints, state) {
    try {
      new PosePicture(this.canvas, body).draw(joints, state);
      return true;
    } catch {
      return false;
    }
  }

  list({off, upright}) {
    const lines = off.map(({name, by}) => el('li', {}, by === null ? `${name} reports no position`
      : `${name} is ${number(Math.abs(degrees(by)), 0)}° off`));
    if (upright !== true) lines.push(el('li', {}, upright === null ? 'it is unknown whether the robot is upright' : 'the robot is not upright'));
    return el('ul', {}, ...lines);
  }
}

const kHeld = ['holding', 'driven', 'starting', 'taking_over', 'found_stiff'];
