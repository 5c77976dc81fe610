// Steering channel: drives the robot while this page sends heartbeats.

const kProtocol = 'darwinop-steering.1';
const kHeartbeat_ms = 80;   // heartbeat interval; the program's timeout is 0.5 s
const kRetry_ms = 1000;
const kNothing = {walks: false, page: 0, limp: [], refused: ''};

export class Steering extends EventTarget {
  constructor(url) {
    super();
    this.url = url;
    this.drives = false;
    this.asking = false; // takeover in progress
    this.ending = false; // the robot completes its steps
    this.text = '';      // why the page does not drive
    this.goals = {};     // by name, rad, not sent yet
    this.walk = null;    // {x, y, a}, repeated in every message while requested
    this.doing = kNothing;
    this.open();
    setInterval(() => this.sendHeartbeat(), kHeartbeat_ms);
    // A hidden page does not drive.
    document.addEventListener('visibilitychange', () => document.hidden && this.leave());
    addEventListener('pagehide', () => this.leave());
  }

  open() {
    this.socket = new WebSocket(this.url, kProtocol);
    this.socket.onmessage = (event) => {
      const message = JSON.parse(event.data);
      if (message.type === 'driving') this.change(message.yours, message.text, message);
      if (message.type === 'doing') this.update(message);
    };
    this.socket.onclose = () => {
      this.change(false, this.drives ? 'The connection was lost. The robot holds.' : this.text);
      setTimeout(() => this.open(), kRetry_ms);
    };
  }

  take() { this.send({take: true}); }

  /// Holds at once.
  stop() { this.end({stop: true}); }

  /// Holds after the present steps.
  leave() { this.end({leave: true}); }

  end(request) {
    this.goals = {};
    this.walk = null;
    this.send(request);  // also during a takeover
  }

  /// Goal of a joint, rad; collected until the next heartbeat.
  aim(name, angle) {
    if (this.drives) this.goals[name] = angle;
  }

  /// null: stand.
  go(walk) {
    this.walk = this.drives ? walk : null;
    this.sendHeartbeat();
  }

  play(page) { if (this.drives) this.send({page, ...this.lasting()}); }

  /// `limb`: "left_arm".
  torque(limb, on) { if (this.drives) this.send({torque: {[limb]: on}, ...this.lasting()}); }

  // Requests that every message must repeat to stay active.
  lasting() { return this.walk ? {walk: this.walk} : {}; }

  sendHeartbeat() {
    if (!this.drives) return;
    this.send({...this.lasting(), ...(Object.keys(this.goals).length > 0 ? {goals: this.goals} : {})});
    this.goals = {};
  }

  send(request) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(request));
  }

  update(doing) {
    this.doing = doing;
    this.dispatchEvent(new Event('change'));
  }

  change(drives, text, {taking = false, ending = false} = {}) {
    if (drives !== this.drives) this.doing = {...kNothing, limp: drives ? [] : this.doing.limp};  // limp limbs stay limp
    this.drives = drives;
    this.asking = taking;
    this.ending = ending;
    this.text = text;
    if (!drives) {
      this.goals = {};
      this.walk = null;
    }
    this.dispatchEvent(new Event('change'));
  }
}
