// A number over the last minutes, as a small curve. Vertical lines mark where what is compared has changed.
import {colour} from './dom.js';

const kKept = 240;  // values: one minute at four a second
const kWidth = 120, kHeight = 20;

export class SparkLine {
  /// `least`: smallest full scale, in the values' unit.
  constructor(least) {
    this.least = least;
    this.values = [];  // {value, mark}; a value of null is a gap
    this.node = document.createElement('canvas');
    this.node.width = kWidth;
    this.node.height = kHeight;
    this.node.ariaHidden = 'true';  // the table has the number
  }

  add(value, mark) {
    this.values.push({value, mark});
    if (this.values.length > kKept) this.values.shift();
  }

  draw() {
    const pen = this.node.getContext('2d'), top = Math.max(this.least, ...this.values.map(({value}) => value ?? 0));
    const x = (i) => kWidth - (this.values.length - i) * (kWidth / kKept), y = (value) => kHeight - 1 - (value / top) * (kHeight - 3);
    pen.clearRect(0, 0, kWidth, kHeight);
    pen.strokeStyle = colour('quiet');
    this.values.forEach(({mark}, i) => { if (mark) pen.strokeRect(x(i), 0, 0, kHeight); });
    pen.strokeStyle = colour('actual');
    pen.beginPath();
    this.values.forEach(({value}, i) => {
      if (value === null) return;
      if (i === 0 || this.values[i - 1].value === null) pen.moveTo(x(i), y(value));
      else pen.lineTo(x(i), y(value));
    });
    pen.stroke();
  }
}
