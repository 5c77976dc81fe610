// Monitor channel: dispatches messages as events named by type; reconnects automatically.
import {kNoData, kNoProgram, kWindowEnded} from './messages.js';
import {isMessage, jointsOf} from './shapes.js';

const kProtocol = 'darwinop-monitor.1';
const kRetry_ms = [250, 500, 1000, 2000];
const kSilent_ms = 500;  // thirty cycles

export class Feed extends EventTarget {
  constructor(url) {
    super();
    this.url = url;
    this.tries = 0;
    this.last_state_ms = null;  // arrival of the newest state
    this.connected = false;
    this.gone = null;  // why there is no runtime
    this.ended = null;  // why the window's program has ended
    this.joints = 0;   // number of joints in the last "hello"
    this.request = {rate: 62.5, camera: 0};
    this.open();
  }

  open() {
    this.socket = new WebSocket(this.url, kProtocol);
    this.socket.binaryType = 'arraybuffer';
    this.socket.onopen = () => {
      this.connected = true;
      this.tries = 0;
      this.ended = null;
      this.ask({});
    };
    this.socket.onmessage = (event) => this.take(event.data);
    this.socket.onclose = () => {
      this.connected = false;
      setTimeout(() => this.open(), kRetry_ms[Math.min(this.tries++, kRetry_ms.length - 1)]);
    };
  }

  /// Sets the rates of states and pictures, Hz.
  ask(request) {
    Object.assign(this.request, request);
    if (this.connected) this.socket.send(JSON.stringify(this.request));
  }

  take(data) {
    if (typeof data !== 'string') return this.emit('picture', data);
    let message;
    try {
      message = JSON.parse(data);
    } catch {
      return undefined;  // ignored; missing states are reported
    }
    if (!isMessage(message) || (message.type === 'state' && jointsOf(message) !== this.joints)) return undefined;
    if (message.type === 'state') this.last_state_ms = performance.now();
    if (message.type === 'hello') {
      this.joints = message.joints.length;
      this.gone = message.period === null ? 'no runtime is running yet' : null;
    }
    if (message.type === 'gone') this.gone = message.reason;
    if (message.type === 'ended') this.ended = message.text;
    return this.emit(message.type, message);
  }

  /// Why the data shown is not current, or null.
  get problem() {
    if (this.ended !== null) return {text: `${kWindowEnded}: ${this.ended} The data shown is old.`};
    if (!this.connected)
      return {text: `${kNoProgram}; the data shown is old. Check that \`darwinop window\` is running.`};
    if (this.gone !== null) return {text: `Robot not available: ${this.gone}`};
    if (this.last_state_ms === null) return {text: 'Waiting for the robot …', mild: true};
    const silent_ms = performance.now() - this.last_state_ms;
    if (silent_ms < kSilent_ms) return null;
    return {text: `${kNoData} for ${(silent_ms / 1000).toFixed(1)} s. The data shown is old.`};
  }

  emit(type, detail) { this.dispatchEvent(new CustomEvent(type, {detail})); }
}
