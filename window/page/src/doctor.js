// Doctor channel: runs darwinop doctor and receives its document, shared by all pages of a window.

const kProtocol = 'darwinop-doctor.1';
const kRetry_ms = 1000;
const kNothing = {command: 'darwinop doctor', runs: false, elsewhere: null, document: null, error: null};

export class Doctor extends EventTarget {
  constructor(url) {
    super();
    this.url = url;
    this.state = kNothing;
    this.open();
  }

  get connected() { return this.socket.readyState === WebSocket.OPEN; }

  open() {
    this.socket = new WebSocket(this.url, kProtocol);
    this.socket.onmessage = ({data}) => {
      this.state = JSON.parse(data);
      this.changed();
    };
    this.socket.onclose = () => {
      this.changed();
      setTimeout(() => this.open(), kRetry_ms);
    };
  }

  changed() { this.dispatchEvent(new Event('change')); }
  check() { if (this.connected) this.socket.send(JSON.stringify({check: true})); }
}

/// Rows of a document of `darwinop doctor --json` (docs/doctor.md): faults first, then other warnings and errors,
/// and lines that need none. A finding that is the evidence of a fault is not repeated. A row: {look, what, evidence, remedy}; texts as the doctor printed them.
export function rowsOf({faults, findings}) {
  const row = (look, {what, evidence = '', remedy = ''}) => ({look, what, evidence, remedy});
  const said = new Set(faults.map(({evidence}) => evidence));
  return {
    faults: faults.map((fault) => row('bad', fault)),
    findings: findings.filter(({level, what, remedy}) => level !== 'ok' && (remedy || !said.has(what)))
      .map((one) => row(one.level === 'fail' ? 'bad' : 'warn', one)),
    fine: findings.filter(({level}) => level === 'ok').map(({what}) => what),
  };
}

/// A text as [{text, code}]: commands stand between backticks.
export function pieces(text) {
  return text.split('`').map((part, i) => ({text: part, code: i % 2 === 1})).filter(({text: part}) => part !== '');
}
