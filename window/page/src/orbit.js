// Orbit control of the 3D view: touch, mouse, wheel and keys.
import {Vector3} from 'three';

const kNearest = 0.35, kFarthest = 4;  // m
const kKeyTurn = 0.12;                 // rad

export class Orbit {
  constructor(canvas, camera) {
    this.camera = camera;
    this.target = new Vector3(0, 0, 0.22);
    this.around = 0.6;  // rad, 0: in front of the robot
    this.above = 0.22;
    this.distance = 1.05;
    this.moved = true;
    this.fingers = new Map();
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    canvas.addEventListener('pointermove', (event) => this.drag(event));
    for (const end of ['pointerup', 'pointercancel'])
      canvas.addEventListener(end, (event) => this.fingers.delete(event.pointerId));
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoom(event.deltaY > 0 ? 1.1 : 0.9);
    }, {passive: false});
    canvas.addEventListener('keydown', (event) => this.key(event));
  }

  spread() {
    const [a, b] = [...this.fingers.values()];
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
  }

  drag(event) {
    const before = this.fingers.get(event.pointerId);
    if (!before) return;
    const apart = this.fingers.size === 2 ? this.spread() : 0;
    this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    if (this.fingers.size === 2 && apart > 0) this.zoom(apart / Math.max(this.spread(), 1));
    else if (this.fingers.size === 1) this.turn((before[0] - event.clientX) * 0.008, (event.clientY - before[1]) * 0.006);
  }

  turn(around, above) {
    this.around += around;
    this.above = Math.min(Math.max(this.above + above, 0.02), 1.5);
    this.moved = true;
  }

  zoom(factor) {
    this.distance = Math.min(Math.max(this.distance * factor, kNearest), kFarthest);
    this.moved = true;
  }

  key(event) {
    const turns = {ArrowLeft: [-kKeyTurn, 0], ArrowRight: [kKeyTurn, 0], ArrowUp: [0, kKeyTurn], ArrowDown: [0, -kKeyTurn]};
    if (turns[event.key]) this.turn(...turns[event.key]);
    else if (event.key === '+' || event.key === '=') this.zoom(0.85);
    else if (event.key === '-') this.zoom(1.18);
    else return;
    event.preventDefault();
  }

  /// Keeps a walking robot in view.
  follow(place) {
    const part = 0.08;
    const dx = place.x - this.target.x, dy = place.y - this.target.y;
    if (Math.abs(dx) + Math.abs(dy) < 1e-4) return;
    this.target.x += dx * part;
    this.target.y += dy * part;
    this.moved = true;
  }

  apply() {
    const flat = Math.cos(this.above) * this.distance;
    this.camera.position.set(this.target.x + flat * Math.cos(this.around), this.target.y - flat * Math.sin(this.around),
      this.target.z + Math.sin(this.above) * this.distance);
    this.camera.lookAt(this.target);
    this.moved = false;
  }
}
