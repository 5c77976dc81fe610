// Transfer: the installer of the command line, driven from the page.
import {ask} from './ask_dialog.js';
import {el} from './dom.js';
import {TransferConsole} from './transfer_console.js';
import {ControllerForm, RobotForm} from './transfer_form.js';
import {TransferProgress} from './transfer_progress.js';

// Before these the page asks.
const kQuestions = {
  uninstall: ['Remove everything of darwinop from the robot?',
    ['Versions, controllers, logs and robot.ini with its offsets go; /etc/rc.local is as before. The robot sits down first.'], 'Remove'],
  'make-default': ['Start it now and at every boot?',
    ['The controller is sent, starts now, and from then on whenever the robot is switched on and sits in its start pose, with ' +
      'nobody at a PC. Mind your fingers.'], 'Make default'],
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
        this.button('uninstall', 'Remove …'), this.check(this.older, 'install an older version, too')),
      this.group('Controller', ...this.controller.nodes, this.button('run', 'Send and run'), this.button('send', 'Send'),
        this.button('make-default', 'Make default …'), this.button('no-default', 'No default any more'),
        this.button('stop', 'Stop what runs'), this.button('logs', 'Logs'),
        this.check(this.anyhow, 'run it whatever the robot’s pose is: I hold it')),
      this.progress.node, this.console.node);
    transfer.addEventListener('lines', ({detail}) => this.console.add(detail));
    transfer.addEventListener('refused', ({detail}) => this.progress.say(detail));
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
    if (action === 'run') request.arguments = this.controller.words();
    if ((action === 'run' && this.anyhow.checked) || (action === 'install' && this.older.checked)) request.force = true;
    this.start(request);
  }

  start(request) {
    const trouble = this.transfer.start(request, this.robot.password.input.value);
    if (trouble) this.progress.say(trouble);
    else this.asks = true;
  }

  change() {
    const {state, connected} = this.transfer;
    for (const button of this.buttons) button.disabled = state.runs || !connected;
    if (!state.runs && state.host_key && this.asks) this.askForKey(state);
    if (!state.runs && this.asks && state.text?.includes('needs a password')) this.robot.password.input.focus();
    if (!state.runs && state.status !== null) this.asks = false;
  }

  /// Only the page that has begun it asks, and once.
  async askForKey({host_key: key, robot}) {
    const {asked} = this.transfer;
    if (asked.host_key) return;  // it has another key than the one that was trusted
    this.asks = false;
    const yes = await ask(`Is this ${robot.address}?`, [
      'This computer has not met it yet. It says that its key is',
      el('code', {}, key),
      'On the robot, ssh-keygen -lf /etc/ssh/ssh_host_ed25519_key.pub shows its own (or the one of another kind there). Straight ' +
        'from this computer into the robot, by cable, nobody can stand between.'], 'Trust this key');
    if (yes) this.start({...asked, host_key: key});
  }

  begin() {}
  restyle() {}
  draw() {}
  tell() {}
  shown(yes) { if (yes) this.console.shown(); }
}
