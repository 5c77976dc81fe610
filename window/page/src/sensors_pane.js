// Motion sensors tab: accelerometer and gyro over time and axis against axis.
import {CurvePlot} from './curve_plot.js';
import {el} from './dom.js';
import {SquarePlot} from './square_plot.js';

const kAxes = ['x', 'y', 'z'], kColours = ['actual', 'target', 'third'];
const kSensors = [
  {key: 'accelerometer', title: 'Accelerometer', unit: 'm/s²', reach: 12, span: [-2, 11]},
  {key: 'gyro', title: 'Gyro', unit: 'rad/s', reach: 2, span: [-0.5, 0.5]},
];

export class SensorsPane {
  constructor(timeline) {
    this.timed = true;
    this.node = el('div', {className: 'pane'});
    this.plots = kSensors.map(({key, title, unit, span}) => new CurvePlot(timeline, {
      title, unit, span, height: 200,
      curves: kAxes.map((axis, i) => ({key: `${key}.${axis}`, name: axis, colour: kColours[i]}))}));
    this.squares = kSensors.map(({key, title, unit, reach}) => ({
      reach,
      title: `${title}, axis against axis`,
      note: `± ${reach} ${unit}`,
      plots: [['x', 'y'], ['x', 'z'], ['y', 'z']].map(([a, b]) =>
        new SquarePlot(timeline, `${key}.${a}`, `${key}.${b}`, `${a} across, ${b} up, ${`± ${reach} ${unit}`}`))}));
    kSensors.forEach((_, i) => this.node.append(this.plots[i].node,
      el('div', {}, el('h3', {}, this.squares[i].title),
        el('div', {className: 'squares'}, ...this.squares[i].plots.map((plot) => plot.node)))));
  }

  begin() {}
  restyle() { this.plots.forEach((plot) => plot.show(plot.curves)); }
  draw() {
    this.plots.forEach((plot) => plot.draw());
    this.turn = ((this.turn ?? 0) + 1) % 3;  // one of three square plots per sensor and frame
    this.squares.forEach(({plots, reach}) => plots[this.turn].draw(reach));
  }
  update() {}
}
