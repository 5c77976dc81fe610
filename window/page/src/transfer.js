// The transfer channel: what the installer is to do, and what becomes of it. All pages of a window see the same.

const kProtocol = 'darwinop-transfer.1';
const kAgain_ms = 1000, kMore_ms = 30;
const kLongest = 4000;  // bytes of a request, less than the program takes
const kNothing = {runs: false, action: null, status: null};

export class Transfer extends EventTarget {
  constructor(url) {
    super();
    this.url = url;
    this.state = kNothing;
    this.known = {robots: [], given: null, controllers: [], examples: [], trouble: ''};
    this.next = 0;       // line of the console that is not here yet
    this.asked = null;   // what this page has started last
    this.open();
  }

  get connected() { return this.socket.readyState === WebSocket.OPEN; }

  open() {
    this.socket = new WebSocket(this.url, kProtocol);
    this.socket.onopen = () => this.more();
    this.socket.onmessage = ({data}) => this.take(JSON.parse(data));
    this.socket.onclose = () => {
      this.dispatchEvent(new Event('change'));
      setTimeout(() => this.open(), kAgain_ms);
    };
  }

  take(said) {
    if (said.type === 'lines') return this.takeLines(said);
    if (said.type === 'refused') return this.dispatchEvent(new CustomEvent('refused', {detail: said.text}));
    if (said.type === 'known') this.known = said;
    if (said.type === 'state') this.state = said;
    return this.dispatchEvent(new CustomEvent(said.type === 'known' ? 'known' : 'change'));
  }

  takeLines({first, lines}) {
    this.dispatchEvent(new CustomEvent('lines', {detail: {lines, missing: first - this.next}}));
    this.next = first + lines.length;
    setTimeout(() => this.more(), kMore_ms);  // no faster than they can be shown
  }

  more() { this.send({more: this.next}); }
  cancel() { this.send({cancel: true}); }
  forget({address, user}) { this.send({forget: {address, user}}); }

  /// The password goes by itself, in no text, and is for this start alone. A sentence when that cannot be.
  start(request, password) {
    const text = JSON.stringify({start: request});
    if (new TextEncoder().encode(text).length > kLongest) return 'Paths and arguments are too long.';
    if (!this.connected) return 'There is no connection to the program of this window.';
    this.asked = request;
    if (password) this.socket.send(new TextEncoder().encode(password));
    this.socket.send(text);
    return '';
  }

  send(words) {
    if (this.connected) this.socket.send(JSON.stringify(words));
  }
}
