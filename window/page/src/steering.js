// Driving the robot from this page: the lease is held while the page speaks, and given back by a stop, a silence, an end.

const kProtocol = 'darwinop-steering.1';
const kSpeak_ms = 80;   // the program lets go after half a second of silence
const kAgain_ms = 1000;
const kNothing = {walks: false, page: 0, limp: [], refused: ''};

export class Steering extends EventTarget {
  constructor(url) {
    super();
    this.url = url;
    this.drives = false;
    this.asking = false; // the robot is being taken
    this.text = '';      // why not, or why no longer
    this.goals = {};     // by name, rad, not sent yet
    this.walk = null;    // {x, y, a}: said again and again while it is wanted
    this.doing = kNothing;
    this.open();
    setInterval(() => this.speak(), kSpeak_ms);
    // Nobody looks: nobody drives.
    document.addEventListener('visibilitychange', () => document.hidden && this.leave());
    addEventListener('pagehide', () => this.leave());
  }

  open() {
    this.socket = new WebSocket(this.url, kProtocol);
    this.socket.onmessage = (event) => {
      const said = JSON.parse(event.data);
      if (said.type === 'driving') this.change(said.yours, said.text, said.taking === true);
      if (said.type === 'doing') this.tell(said);
    };
    this.socket.onclose = () => {
      this.change(false, this.drives ? 'The connection broke. The robot holds.' : this.text);
      setTimeout(() => this.open(), kAgain_ms);
    };
  }

  take() { this.send({take: true}); }

  /// At once.
  stop() { this.end({stop: true}); }

  /// After the steps under way.
  leave() { this.end({leave: true}); }

  end(words) {
    this.goals = {};
    this.walk = null;
    this.send(words);  // also while the robot is being taken
  }

  /// A joint's goal, rad; many a second are one message.
  aim(name, angle) {
    if (this.drives) this.goals[name] = angle;
  }

  /// null: stand.
  go(walk) {
    this.walk = this.drives ? walk : null;
    this.speak();
  }

  play(page) { if (this.drives) this.send({page, ...this.lasting()}); }

  /// `limb`: "left_arm".
  torque(limb, on) { if (this.drives) this.send({torque: {[limb]: on}, ...this.lasting()}); }

  // What every message has to say again, or it would be no longer wanted.
  lasting() { return this.walk ? {walk: this.walk} : {}; }

  speak() {
    if (!this.drives) return;
    this.send({...this.lasting(), ...(Object.keys(this.goals).length > 0 ? {goals: this.goals} : {})});
    this.goals = {};
  }

  send(words) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(words));
  }

  tell(doing) {
    this.doing = doing;
    this.dispatchEvent(new Event('change'));
  }

  change(drives, text, asking = false) {
    if (drives !== this.drives) this.doing = {...kNothing, limp: drives ? [] : this.doing.limp};  // what is limp stays so
    this.drives = drives;
    this.asking = asking;
    this.text = text;
    if (!drives) {
      this.goals = {};
      this.walk = null;
    }
    this.dispatchEvent(new Event('change'));
  }
}
