// Which part of the record is shown: the newest seconds, or, paused, a part that was picked.

export const kLengths = [5, 10, 30, 60, 300];  // s

export class Timeline extends EventTarget {
  constructor() {
    super();
    this.live = null;    // Store
    this.frozen = null;  // Store, while paused
    this.length = 10;
    this.picked = null;  // [from, to], while paused
  }

  get paused() { return this.frozen !== null; }
  get store() { return this.frozen ?? this.live; }

  /// [from, to] in s on the robot's clock, or null while there is nothing.
  get range() {
    if (!this.store || this.store.count === 0) return null;
    return this.picked ?? [this.store.newest - this.length, this.store.newest];
  }

  restart(store) {
    this.live = store;
    this.resume();
  }

  pause() {
    if (this.paused || !this.live || this.live.count === 0) return;
    this.frozen = this.live.frozen();
    this.picked = [this.frozen.newest - this.length, this.frozen.newest];
    this.tell();
  }

  resume() {
    this.frozen = this.picked = null;
    this.tell();
  }

  setLength(length) {
    this.length = length;
    if (this.paused) this.picked = [this.picked[1] - length, this.picked[1]];
    this.tell();
  }

  /// Looks at a part more closely; that needs a pause.
  zoom(from, to) {
    this.pause();
    if (!this.paused || !(to - from > 0.02)) return;
    this.picked = [from, to];
    this.tell();
  }

  /// Nearer (< 1) or wider (> 1) about a time.
  scale(factor, about = null) {
    const range = this.range;
    if (!range) return;
    const centre = about ?? (range[0] + range[1]) / 2;
    this.zoom(centre + (range[0] - centre) * factor, centre + (range[1] - centre) * factor);
  }

  /// Earlier (< 0) or later, in parts of what is shown.
  shift(part) {
    const range = this.range;
    if (!range) return;
    const by = (range[1] - range[0]) * part;
    this.zoom(range[0] + by, range[1] + by);
  }

  whole() {
    if (this.paused) this.setLength(this.length);
  }

  tell() { this.dispatchEvent(new Event('change')); }
}
