// Plot of one sensor axis against another over the time range shown.
import {colour, el} from './dom.js';

export class SquarePlot {
  constructor(timeline, across, up, caption) {
    this.timeline = timeline;
    this.across = [];
    this.up = [];
    this.canvas = el('canvas', {role: 'img', ariaLabel: caption});
    this.node = el('figure', {}, this.canvas, el('figcaption', {}, caption));
    this.keys = [across, up];
  }

  draw(reach) {
    const range = this.timeline.range, store = this.timeline.store;
    const side = this.canvas.clientWidth * devicePixelRatio;
    if (!range || side === 0) return;
    if (this.canvas.width !== Math.round(side)) this.canvas.width = this.canvas.height = Math.round(side);
    const first = store.find(range[0]), last = Math.min(store.find(range[1]) + 1, store.count);
    store.read(store.index.get(this.keys[0]), first, last, this.across);
    store.read(store.index.get(this.keys[1]), first, last, this.up);
    this.paint(this.canvas.getContext('2d'), this.canvas.width, reach);
  }

  paint(pen, side, reach) {
    const place = (value) => (0.5 + value / reach / 2) * side;
    pen.clearRect(0, 0, side, side);
    pen.strokeStyle = colour('line');
    pen.lineWidth = devicePixelRatio;
    pen.beginPath();
    pen.moveTo(side / 2, 0); pen.lineTo(side / 2, side);
    pen.moveTo(0, side / 2); pen.lineTo(side, side / 2);
    pen.stroke();
    pen.strokeStyle = colour('actual');
    pen.beginPath();
    let pen_down = false;
    this.across.forEach((x, i) => {
      const y = this.up[i];
      if (x === null || y === null) { pen_down = false; return; }
      if (pen_down) pen.lineTo(place(x), side - place(y));
      else pen.moveTo(place(x), side - place(y));
      pen_down = true;
    });
    pen.stroke();
    const n = this.across.length - 1;
    if (n < 0 || this.across[n] === null || this.up[n] === null) return;
    pen.fillStyle = colour('target');
    pen.beginPath();
    pen.arc(place(this.across[n]), side - place(this.up[n]), 4 * devicePixelRatio, 0, 7);
    pen.fill();
  }
}
