// Adapts frame rate and resolution of the 3D view to the computer, so that the curves stay smooth.
import {kGraphicsCard} from './graphics.js';

const kSteps = [  // draw every n-th frame at this fraction of the screen resolution
  {every: 1, sharpness: 1}, {every: 2, sharpness: 0.75}, {every: 3, sharpness: 0.6}, {every: 4, sharpness: 0.5},
  {every: 6, sharpness: 0.5},
];
const kBest = kGraphicsCard ? 0 : 2;
const kLook_ms = 1500;
const kLate_ms = 25;    // between two frames: one was dropped
const kHidden_ms = 600;
const kFew = 3;         // late frames in an interval before a step down
const kPatience = 20;   // intervals without late frames before a step up; doubled after each step down

export class Pace {
  constructor() {
    this.step = kBest;
    this.patience = kPatience;
    this.last = performance.now();
    this.begin(this.last);
    this.good = 0;
    this.frames = 0;
    this.changed = true;
  }

  get sharpness() { return kSteps[this.step].sharpness; }
  due() { return this.frames % kSteps[this.step].every === 0; }

  begin(now) {
    this.since = now;
    this.late = 0;
  }

  frame() {
    ++this.frames;
    const now = performance.now(), passed = now - this.last;
    this.last = now;
    if (passed > kHidden_ms) return this.begin(now);
    if (passed > kLate_ms) ++this.late;
    if (now - this.since < kLook_ms) return undefined;
    if (this.late > kFew) this.take(this.step + 1);
    else if (this.late === 0 && ++this.good > this.patience) this.take(this.step - 1);
    return this.begin(now);
  }

  take(step) {
    this.good = 0;
    const wanted = Math.min(Math.max(step, kBest), kSteps.length - 1);
    if (wanted === this.step) return;
    if (wanted > this.step) this.patience *= 2;
    this.step = wanted;
    this.changed = true;
  }
}
