// Transfer tab: runs darwinop install from the page.
import {ask} from './ask_dialog.js';
import {el} from './dom.js';
import {TransferConsole} from './transfer_console.js';
import {ControllerForm, RobotForm} from './transfer_form.js';
import {TransferProgress} from './transfer_progress.js';

// Actions that require confirmation.
const kQuestions = {
  uninstall: ['Remove everything of darwinop from the robot?',
    ['Deletes versions, controllers, logs and robot.ini with its offsets, and restores /etc/rc.local. The robot sits down first.'], 'Remove'],
  'make-default': ['Start it now and at every boot?',
    ['Sends the controller and starts it now and whenever the robot is switched on in its start pose, without a PC. ' +
      'Keep your fingers clear.'], 'Make default'],
};

export class TransferPane {
  constructor(transfer) {
    this.transfer = transfer;
    this.robot = new RobotForm(transfer);
    this.controller = new ControllerForm(transfer);
    this.progress = new TransferProgress(transfer);
    this.console = new TransferConsole();
    this.buttons = [];
    this.older = el('input', {type: 'checkbox', id: 'transfer-older'});
    this.anyhow = el('input', {type: 'checkbox', id: 'transfer-anyhow'});
    this.node = el('div', {className: 'pane transfer'},
      this.group('Robot', ...this.robot.fields, this.button('status', 'Connect'), ...this.robot.more),
      this.group('Runtime', this.button('install', 'Install or update'), this.button('rollback', 'Go back by one version'),
        this.button('uninstall', 'Remove …'), this.check(this.older, 'allow an older version')),
      this.group('Controller', ...this.controller.nodes, this.button('run', 'Send and run'), this.button('send', 'Send'),
        this.button('make-default', 'Make default …'), this.button('no-default', 'Remove default'),
        this.button('stop', 'Stop'), this.button('logs', 'Logs'),
        this.check(this.anyhow, 'run in any pose: I hold the robot')),
      this.progress.node, this.console.node);
    transfer.addEventListener('lines', ({detail}) => this.console.add(detail));
    transfer.addEventListener('refused', ({detail}) => this.progress.showError(detail));
    transfer.addEventListener('change', () => this.change());
    this.change();
  }

  group(name, ...nodes) { return el('fieldset', {}, el('legend', {}, name), el('div', {className: 'choose'}, ...nodes)); }
  check(box, text) { return el('label', {}, box, text); }

  button(action, text) {
    const button = el('button', {type: 'button', id: `transfer-${action}`}, text);
    button.addEventListener('click', () => this.act(action));
    this.buttons.push(button);
    return button;
  }

  async act(action) {
    const question = kQuestions[action];
    if (question && !(await ask(...question))) return;
    const request = {action, robot: this.robot.robot()};
    if (['send', 'run', 'make-default'].includes(action)) request.controller = this.controller.controller();
    if (action === 'run') request.arguments = this.controller.argumentList();
    if ((action === 'run' && this.anyhow.checked) || (action === 'install' && this.older.checked)) request.force = true;
    this.start(request);
  }

  start(request) {
    const error = this.transfer.start(request, this.robot.password.input.value);
    if (error) this.progress.showError(error);
    else this.asks = true;
  }

  change() {
    const {state, connected} = this.transfer;
    for (const button of this.buttons) button.disabled = state.runs || !connected;
    if (!state.runs && state.host_key && this.asks) this.askForKey(state);
    if (!state.runs && this.asks && state.text?.includes('needs a password')) this.robot.password.input.focus();
    if (!state.runs && state.status !== null) this.asks = false;
  }

  /// Only the page that started the run asks, once.
  async askForKey({host_key: key, robot}) {
    const {asked} = this.transfer;
    if (asked.host_key) return;  // the host key differs from the trusted one
    this.asks = false;
    const yes = await ask(`Is this ${robot.address}?`, [
      'The robot is not known to this computer. Its key fingerprint is',
      el('code', {}, key),
      'On the robot, ssh-keygen -lf /etc/ssh/ssh_host_ed25519_key.pub shows its fingerprint (or another ssh_host_*_key.pub there). ' +
        'A direct cable between this computer and the robot cannot be intercepted.'], 'Trust this key');
    if (yes) this.start({...asked, host_key: key});
  }

  begin() {}
  restyle() {}
  draw() {}
  update() {}
  shown(yes) { if (yes) this.console.shown(); }
}
