// Ring buffer of the last minutes of every column.

export const kMinutesKept = 5;

export class Store {
  /// `before`: an obsolete store whose memory is reused.
  constructor(columns, rows, before = null) {
    this.columns = columns;
    this.rows = rows;
    this.index = new Map(columns.map((column, i) => [column.key, i]));
    const again = before?.rows === rows && before.data.length === columns.length;
    this.data = again ? before.data : columns.map((column, i) => (i < 2 ? new Float64Array(rows) : new Float32Array(rows)));
    this.origin = 0;   // time of the first row; origin of the time axes
    this.written = 0;  // rows written in total; the oldest are overwritten
  }

  get count() { return Math.min(this.written, this.rows); }

  add(row) {
    if (this.written === 0) [this.origin] = row;
    const at = this.written % this.rows;
    for (let i = 0; i < row.length; ++i) this.data[i][at] = row[i];
    ++this.written;
  }

  /// Row `n` of those kept; 0 is the oldest.
  at(column, n) { return this.data[column][(this.written - this.count + n) % this.rows]; }
  get newest() { return this.count === 0 ? NaN : this.at(0, this.count - 1); }
  get oldest() { return this.count === 0 ? NaN : this.at(0, 0); }

  /// Number of the first row at or after a time.
  find(time) {
    let low = 0, high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.at(0, middle) < time) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /// Copies rows [first, last) of a column to `into`; null: unknown.
  read(column, first, last, into) {
    const data = this.data[column], rows = this.rows;
    let at = (this.written - this.count + first) % rows;
    into.length = last - first;
    for (let i = 0; i < into.length; ++i) {
      const value = data[at];
      into[i] = Number.isNaN(value) ? null : value;
      if (++at === rows) at = 0;
    }
  }

  /// Copy of the present rows.
  frozen() {
    const copy = new Store(this.columns, this.rows);
    copy.data = this.data.map((column) => column.slice());
    copy.origin = this.origin;
    copy.written = this.written;
    return copy;
  }
}
