// Live channel: the comparison of the robot with its twin, shared by all pages of a window.

const kProtocol = 'darwinop-live.1';
const kRetry_ms = 1000;

export class Live extends EventTarget {
  constructor(url) {
    super();
    this.url = url;
    this.state = null;  // last message "comparison"
    this.open();
  }

  get connected() { return this.socket.readyState === WebSocket.OPEN; }

  open() {
    this.socket = new WebSocket(this.url, kProtocol);
    this.socket.onmessage = ({data}) => this.take(JSON.parse(data));
    this.socket.onclose = () => {
      this.state = null;
      this.dispatchEvent(new Event('change'));
      setTimeout(() => this.open(), kRetry_ms);
    };
  }

  take(message) {
    if (message.type === 'refused') return this.dispatchEvent(new CustomEvent('refused', {detail: message.text}));
    if (message.type !== 'comparison') return undefined;
    this.state = message;
    return this.dispatchEvent(new Event('change'));
  }

  /// Begins again if it runs. `support`: clamped or floor.
  run(model, support) { this.send({run: {model, support}}); }
  stop() { this.send({run: null}); }
  send(request) {
    if (this.connected) this.socket.send(JSON.stringify(request));
  }
}
