// Transfer channel: starts darwinop-install and receives its state and output, shared by all pages of a window.

const kProtocol = 'darwinop-transfer.1';
const kRetry_ms = 1000, kMore_ms = 30;
const kLongest = 4000;  // bytes of a request, below the program's limit
const kNothing = {runs: false, action: null, status: null};

export class Transfer extends EventTarget {
  constructor(url) {
    super();
    this.url = url;
    this.state = kNothing;
    this.known = {robots: [], given: null, controllers: [], examples: [], trouble: ''};  // keep-word: member of the message
    this.next = 0;       // first console line not received yet
    this.asked = null;   // last request of this page
    this.open();
  }

  get connected() { return this.socket.readyState === WebSocket.OPEN; }

  open() {
    this.socket = new WebSocket(this.url, kProtocol);
    this.socket.onopen = () => this.more();
    this.socket.onmessage = ({data}) => this.take(JSON.parse(data));
    this.socket.onclose = () => {
      this.dispatchEvent(new Event('change'));
      setTimeout(() => this.open(), kRetry_ms);
    };
  }

  take(message) {
    if (message.type === 'lines') return this.takeLines(message);
    if (message.type === 'refused') return this.dispatchEvent(new CustomEvent('refused', {detail: message.text}));
    if (message.type === 'known') this.known = message;
    if (message.type === 'state') this.state = message;
    return this.dispatchEvent(new CustomEvent(message.type === 'known' ? 'known' : 'change'));
  }

  takeLines({first, lines}) {
    this.dispatchEvent(new CustomEvent('lines', {detail: {lines, missing: first - this.next}}));
    this.next = first + lines.length;
    setTimeout(() => this.more(), kMore_ms);  // flow control
  }

  more() { this.send({more: this.next}); }
  cancel() { this.send({cancel: true}); }
  forget({address, user}) { this.send({forget: {address, user}}); }

  /// Sends the password as a separate binary message for this start only. Returns an error text or ''.
  start(request, password) {
    const text = JSON.stringify({start: request});
    if (new TextEncoder().encode(text).length > kLongest) return 'Paths and arguments are too long.';
    if (!this.connected) return 'No connection to the window’s program.';
    this.asked = request;
    if (password) this.socket.send(new TextEncoder().encode(password));
    this.socket.send(text);
    return '';
  }

  send(request) {
    if (this.connected) this.socket.send(JSON.stringify(request));
  }
}
