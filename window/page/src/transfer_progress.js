// Progress of the installer: bar, step, result, Cancel button.
import {el, setClass, setText} from './dom.js';
import {kNothingRuns} from './messages.js';

export class TransferProgress {
  constructor(transfer) {
    this.transfer = transfer;
    this.fill = el('b');
    this.bar = el('div', {className: 'progress', role: 'progressbar', ariaLabel: 'Progress', ariaValueMin: '0', ariaValueMax: '100'}, this.fill);
    this.status = el('p', {role: 'status', id: 'transfer-state'});
    this.cancel = el('button', {type: 'button', id: 'transfer-cancel', className: 'danger'}, 'Cancel');
    this.cancel.addEventListener('click', () => transfer.cancel());
    this.node = el('div', {className: 'transfer-progress'}, this.bar, this.status, this.cancel);
    transfer.addEventListener('change', () => this.update());
    this.update();
  }

  /// Shows an error of the page until the next start.
  showError(text) {
    setClass(this.status, 'bad');
    setText(this.status, text);
  }

  update() {
    const {state} = this.transfer, {runs, step} = state;
    const done = ended(state) === 'good' ? 1 : step ? (step.number - 1 + (step.part ?? 0)) / step.of : 0;
    this.fill.style.width = `${(100 * done).toFixed(1)}%`;
    setClass(this.bar, ['progress', runs && step?.part == null ? 'busy' : '', ended(state)].join(' ').trim());
    this.bar.ariaValueNow = String(Math.round(100 * done));
    this.cancel.disabled = !runs || state.cancelled;
    setClass(this.status, ended(state));
    setText(this.status, statusText(state));
    this.bar.ariaValueText = this.status.textContent || 'nothing runs';
  }
}

/// '' while running or before the first run.
function ended({runs, status, cancelled}) {
  if (runs || status === null) return '';
  return cancelled ? 'warn' : status === 0 ? 'good' : 'bad';
}

const kNames = {status: 'Connecting', install: 'Installing', send: 'Sending', run: 'Running', 'make-default': 'Making default',
  'no-default': 'Clearing the default', stop: 'Stopping', logs: 'Logs', rollback: 'Going back', uninstall: 'Removing'};

function statusText(state) {
  const {runs, step, text, cancelled} = state;
  if (state.action === null) return kNothingRuns;
  const who = `${kNames[state.action]}, ${state.robot.user}@${state.robot.address}`;
  const how = {good: 'done', warn: 'cancelled', bad: 'failed'}[ended(state)];
  if (how) return `${who}: ${how}${text ? `. ${text}` : ''}${state.status > 1 ? ` (status ${state.status})` : ''}`;
  const at = step ? `step ${step.number} of ${step.of}, ${step.name}${step.part === null ? '' : `, ${Math.floor(100 * step.part)} %`}` : 'starting';
  return `${who}: ${cancelled ? 'cancelling safely; ' : ''}${runs ? at : ''}`;
}
