// What darwinop doctor finds, on the first tab; a button runs it.
import {pieces, rowsOf} from './doctor.js';
import {el, setText} from './dom.js';
import {kDoctorRuns, kNotChecked} from './messages.js';

const withCode = (text) => pieces(text).map((piece) => (piece.code ? el('code', {}, piece.text) : piece.text));

export class DoctorPanel {
  constructor(doctor) {
    this.doctor = doctor;
    this.button = el('button', {type: 'button', id: 'doctor-check'}, 'Check the robot');
    this.button.addEventListener('click', () => doctor.check());
    this.status = el('p', {className: 'note', role: 'status'});
    this.summary = el('summary');
    this.rows = el('div');
    this.result = el('details', {open: true, hidden: true}, this.summary, this.rows);
    this.node = el('section', {className: 'doctor', ariaLabel: 'Check of the robot'},
      el('div', {className: 'choose'}, this.button, this.status), this.result);
    doctor.addEventListener('change', () => this.change());
    this.change();
  }

  change() {
    const {state, connected} = this.doctor, {document: found} = state;
    this.button.disabled = state.runs || state.elsewhere !== null || !connected;
    setText(this.button, found === null && state.error === null ? 'Check the robot' : 'Check again');
    this.status.replaceChildren(...withCode(this.statusText(state)));
    this.result.hidden = found === null;
    if (found !== null && found !== this.shown) this.show(found);
    this.shown = found;
  }

  statusText({command, runs, elsewhere, document: found, error}) {
    if (elsewhere !== null) return elsewhere;
    if (runs) return `${kDoctorRuns} \`${command}\``;
    return error ?? (found === null ? kNotChecked : `\`${command}\``);
  }

  show(found) {
    const {faults, findings, fine} = rowsOf(found);
    setText(this.summary, found.summary);
    this.rows.replaceChildren(...[...faults, ...findings].map((row) => this.row(row)),
      ...(fine.length > 0 ? [el('details', {}, el('summary', {}, `${fine.length} without a fault`),
        el('ul', {}, ...fine.map((text) => el('li', {}, text))))] : []));
  }

  row({look, what, evidence, remedy}) {
    return el('div', {className: `fault ${look}`}, el('p', {}, el('strong', {}, what)),
      ...(evidence ? [el('p', {}, `Because ${evidence}`)] : []),
      ...(remedy ? [el('p', {}, el('strong', {}, 'Remedy: '), ...withCode(remedy))] : []));
  }
}
