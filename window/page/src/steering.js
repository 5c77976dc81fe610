// Driving the robot from this page: the lease is held while the page speaks, and given back by a stop, a silence, an end.

const kProtocol = 'darwinop-steering.1';
const kSpeak_ms = 80;   // the program lets go after half a second of silence
const kAgain_ms = 1000;

export class Steering extends EventTarget {
  constructor(url) {
    super();
    this.url = url;
    this.drives = false;
    this.text = '';      // why not, or why no longer
    this.goals = {};     // by name, rad, not sent yet
    this.open();
    setInterval(() => this.speak(), kSpeak_ms);
    // Nobody looks: nobody drives.
    document.addEventListener('visibilitychange', () => document.hidden && this.stop());
    addEventListener('pagehide', () => this.stop());
  }

  open() {
    this.socket = new WebSocket(this.url, kProtocol);
    this.socket.onmessage = (event) => {
      const said = JSON.parse(event.data);
      if (said.type === 'driving') this.change(said.yours, said.text);
    };
    this.socket.onclose = () => {
      this.change(false, this.drives ? 'The connection broke. The robot holds.' : this.text);
      setTimeout(() => this.open(), kAgain_ms);
    };
  }

  take() { this.send({take: true}); }

  stop() {
    this.goals = {};
    if (this.drives) this.send({stop: true});
  }

  /// A joint's goal, rad; many a second are one message.
  aim(name, angle) {
    if (this.drives) this.goals[name] = angle;
  }

  speak() {
    if (!this.drives) return;
    this.send(Object.keys(this.goals).length > 0 ? {goals: this.goals} : {});
    this.goals = {};
  }

  send(words) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(words));
  }

  change(drives, text) {
    this.drives = drives;
    this.text = text;
    if (!drives) this.goals = {};
    this.dispatchEvent(new Event('change'));
  }
}
