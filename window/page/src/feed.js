// The channel to the robot: what it says, as events named after the type of the message; comes back by itself.
import {isMessage, jointsOf} from './shapes.js';

const kProtocol = 'darwinop-monitor.1';
const kAgain_ms = [250, 500, 1000, 2000];
const kSilent_ms = 500;  // thirty cycles

export class Feed extends EventTarget {
  constructor(url) {
    super();
    this.url = url;
    this.tries = 0;
    this.heard_ms = null;  // when the newest state came
    this.connected = false;
    this.gone = null;  // why there is no runtime, in words
    this.ended = null;  // why the program has ended
    this.joints = 0;   // of the last "hello"
    this.wish = {rate: 62.5, camera: 0};
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
      setTimeout(() => this.open(), kAgain_ms[Math.min(this.tries++, kAgain_ms.length - 1)]);
    };
  }

  /// How many states and pictures a second are wanted.
  ask(wish) {
    Object.assign(this.wish, wish);
    if (this.connected) this.socket.send(JSON.stringify(this.wish));
  }

  take(data) {
    if (typeof data !== 'string') return this.emit('picture', data);
    let message;
    try {
      message = JSON.parse(data);
    } catch {
      return undefined;  // not ours to mend; the silence will show
    }
    if (!isMessage(message) || (message.type === 'state' && jointsOf(message) !== this.joints)) return undefined;
    if (message.type === 'state') this.heard_ms = performance.now();
    if (message.type === 'hello') {
      this.joints = message.joints.length;
      this.gone = message.period === null ? 'no runtime runs yet' : null;
    }
    if (message.type === 'gone') this.gone = message.reason;
    if (message.type === 'ended') this.ended = message.text;
    return this.emit(message.type, message);
  }

  /// What is wrong with the picture that the page shows, or null.
  get trouble() {
    if (this.ended !== null) return {text: `This window has ended: ${this.ended} What you see is old.`};
    if (!this.connected)
      return {text: 'No connection to the window’s program. What you see is old. Is `darwinop window` still running?'};
    if (this.gone !== null) return {text: `The robot is gone: ${this.gone}`};
    if (this.heard_ms === null) return {text: 'Waiting for the robot …', mild: true};
    const silent_ms = performance.now() - this.heard_ms;
    if (silent_ms < kSilent_ms) return null;
    return {text: `Nothing new from the robot for ${(silent_ms / 1000).toFixed(1)} s. What you see is old.`};
  }

  emit(type, detail) { this.dispatchEvent(new CustomEvent(type, {detail})); }
}
