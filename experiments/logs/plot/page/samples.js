// The samples of a figure: rows of a chart, and values near a place on its axis.
"use strict";
const samplesOf = (figure) => {
  const axes = figure.axes.map((x) => x.map((v) => (v === null ? NaN : v)));
  const rises = (x) => x.every((v, i) => i === 0 || v > x[i - 1]);
  const risingAxis = axes.map(rises);
  const isRising = (curve) => risingAxis[curve.x];

  // Table of a panel. null: no sample of this curve; NaN: gap in its line.
  function table(panel) {
    const n = panel.curves.length;
    const rows = [];
    if (panel.curves.every(isRising)) {
      const byX = new Map();
      panel.curves.forEach((curve, c) => {
        axes[curve.x].forEach((x, i) => {
          let row = byX.get(x);
          if (row === undefined) byX.set(x, (row = [x].concat(new Array(n).fill(null))));
          row[c + 1] = curve.y[i] === null ? NaN : curve.y[i];
        });
      });
      return [...byX.values()].sort((a, b) => a[0] - b[0]);
    }
    // x is not monotonic (an angle): keep the order of the samples.
    panel.curves.forEach((curve, c) => {
      axes[curve.x].forEach((x, i) => {
        if (!Number.isFinite(x)) return;
        const row = [x].concat(new Array(n).fill(null));
        row[c + 1] = curve.y[i] === null ? NaN : curve.y[i];
        rows.push(row);
      });
    });
    // dygraphs uses the first and last row as the ends of the axis.
    let low = Infinity, high = -Infinity;
    for (const [x] of rows) {
      low = Math.min(low, x);
      high = Math.max(high, x);
    }
    const end = (x) => [x].concat(new Array(n).fill(null));
    return [end(low), ...rows, end(high)];
  }

  // The sample of a curve closest to x; null if it is farther than two mean sample distances.
  function near(curve, x) {
    const xs = axes[curve.x];
    let low = 0, high = xs.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (xs[middle] <= x) low = middle;
      else high = middle;
    }
    const best = Math.abs(xs[low] - x) < Math.abs(xs[high] - x) ? low : high;
    const apart = (xs[xs.length - 1] - xs[0]) / Math.max(1, xs.length - 1);
    return Math.abs(xs[best] - x) <= 2 * apart ? curve.y[best] : null;
  }

  return { isRising, table, near };
};
