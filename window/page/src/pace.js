// How often and how sharply the robot is drawn: less on a computer without a graphics card, so that the curves stay smooth.

const kSteps = [  // every so many frames, at this part of the screen's sharpness
  {every: 1, sharpness: 1}, {every: 2, sharpness: 0.75}, {every: 3, sharpness: 0.5}, {every: 6, sharpness: 0.5},
];
const kLook_ms = 1500;
const kSlow_ms = 20;    // a frame takes longer: a step down
const kPatience = 20;   // looks without a slow one before a step up is tried

export class Pace {
  constructor() {
    this.step = 0;
    this.good = 0;
    this.frames = 0;
    this.since = performance.now();
    this.changed = true;
  }

  get sharpness() { return kSteps[this.step].sharpness; }
  due() { return this.frames % kSteps[this.step].every === 0; }

  frame() {
    ++this.frames;
    const now = performance.now(), passed = now - this.since;
    if (passed < kLook_ms) return;
    const each = passed / this.frames;
    this.frames = 0;
    this.since = now;
    if (each > 4 * kLook_ms / 10) return;  // the tab was hidden
    if (each > kSlow_ms) this.take(this.step + 1);
    else if (++this.good > kPatience) this.take(this.step - 1);
  }

  take(step) {
    this.good = 0;
    const wanted = Math.min(Math.max(step, 0), kSteps.length - 1);
    this.changed ||= wanted !== this.step;
    this.step = wanted;
  }
}
