// Time range shown: the newest seconds, or a chosen range while paused.

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

  /// [from, to] in s on the robot's clock; null: no data.
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
    this.update();
  }

  resume() {
    this.frozen = this.picked = null;
    this.update();
  }

  setLength(length) {
    this.length = length;
    if (this.paused) this.picked = [this.picked[1] - length, this.picked[1]];
    this.update();
  }

  /// Shows a range; pauses.
  zoom(from, to) {
    this.pause();
    if (!this.paused || !(to - from > 0.02)) return;
    this.picked = [from, to];
    this.update();
  }

  /// Zooms in (< 1) or out (> 1) about a time.
  scale(factor, about = null) {
    const range = this.range;
    if (!range) return;
    const centre = about ?? (range[0] + range[1]) / 2;
    this.zoom(centre + (range[0] - centre) * factor, centre + (range[1] - centre) * factor);
  }

  /// Shifts earlier (< 0) or later, as a fraction of the range.
  shift(part) {
    const range = this.range;
    if (!range) return;
    const by = (range[1] - range[0]) * part;
    this.zoom(range[0] + by, range[1] + by);
  }

  whole() {
    if (this.paused) this.setLength(this.length);
  }

  update() { this.dispatchEvent(new Event('change')); }
}
