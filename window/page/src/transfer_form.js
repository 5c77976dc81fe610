// Forms for robot, login and controller. The password is kept in this page only.
import {el} from './dom.js';

const kFirst = {address: '192.168.123.1', user: 'darwin', key: '', port: 0};
const robotName = ({user, address}) => `${user}@${address}`;

function field(id, label, more) {
  const input = el('input', {type: 'text', id, autocomplete: 'off', spellcheck: false, ...more});
  return {input, node: el('div', {className: 'field'}, el('label', {htmlFor: id}, label), input)};
}

export class RobotForm {
  constructor(transfer) {
    this.transfer = transfer;
    this.used = el('select', {id: 'robot-used'});
    this.address = field('robot-address', 'Address', {size: 13});
    this.user = field('robot-user', 'User', {size: 7});
    this.password = field('robot-password', 'Password', {type: 'password', size: 9, autocomplete: 'new-password'});
    this.key = field('robot-key', 'Key file', {placeholder: 'default keys of ssh', size: 22});
    this.port = field('robot-port', 'ssh port', {type: 'number', min: 1, max: 65535, placeholder: '22'});
    this.forget = el('button', {type: 'button'}, 'Forget this robot');
    this.error = el('p', {className: 'note', role: 'status'});
    this.usedField = el('div', {className: 'field', hidden: true}, el('label', {htmlFor: 'robot-used'}, 'Used before'), this.used);
    this.details = el('details', {}, el('summary', {}, 'Key, port'),
      el('div', {className: 'choose'}, this.key.node, this.port.node, this.forget));
    this.fields = [this.usedField, this.address.node, this.user.node, this.password.node];
    this.more = [this.details, this.error];
    for (const {input} of [this.address, this.user, this.password, this.key, this.port])
      input.addEventListener('input', () => { this.typed = true; });
    this.used.addEventListener('change', () => this.fill(this.robots[this.used.selectedIndex]));
    this.forget.addEventListener('click', () => transfer.forget(this.robot()));
    transfer.addEventListener('known', () => this.offer());
    this.fill(kFirst);
  }

  offer() {
    const {robots, given, trouble: error} = this.transfer.known, first = this.robots === undefined;  // keep-word
    this.robots = robots;
    this.usedField.hidden = robots.length === 0;
    this.used.replaceChildren(...robots.map((robot) => el('option', {}, robotName(robot))));
    this.error.textContent = error;
    const usual = given ?? robots[0];  // robot of the command line, otherwise the last one used
    if (first && usual && !this.typed) this.fill(usual);
    this.used.selectedIndex = robots.findIndex((robot) => robotName(robot) === robotName(this.robot()));
  }

  fill({address, user, key, port}) {
    this.address.input.value = address;
    this.user.input.value = user;
    this.key.input.value = key;
    this.port.input.value = port === 0 ? '' : String(port);
    if (key || port) this.details.open = true;
  }

  robot() {
    return {address: this.address.input.value.trim(), user: this.user.input.value.trim(), key: this.key.input.value.trim(),
      port: Number(this.port.input.value)};
  }
}

export class ControllerForm {
  constructor(transfer) {
    this.folder = field('controller-folder', 'Folder of the controller', {size: 36});
    this.folder.input.setAttribute('list', 'controller-folders');
    this.folder.node.classList.add('wide');
    this.arguments = field('controller-arguments', 'Arguments', {size: 14});
    this.list = el('datalist', {id: 'controller-folders'});
    this.nodes = [this.folder.node, this.arguments.node, this.list];
    transfer.addEventListener('known', () => this.offer(transfer.known));
  }

  offer({controllers, examples}) {
    const all = [...new Set([...controllers, ...examples])];
    this.list.replaceChildren(...all.map((value) => el('option', {value})));
    if (this.folder.input.value === '' && controllers.length > 0) this.folder.input.value = controllers[0];
  }

  controller() { return this.folder.input.value.trim(); }
  argumentList() { return this.arguments.input.value.split(/\s+/).filter((word) => word !== ''); }
}
