// All curves tab: target and actual position of all joints.
import {CurvePlot} from './curve_plot.js';
import {el} from './dom.js';

export class CurvesPane {
  constructor(timeline, choose) {
    this.timeline = timeline;
    this.choose = choose;
    this.timed = true;
    this.node = el('div', {className: 'pane'});
    this.plots = [];
    this.turn = 0;
  }

  begin(joints) {
    const scale = 180 / Math.PI;
    this.plots = joints.map(({name}) => new CurvePlot(this.timeline, {
      title: name, unit: '', height: 74, plain: true,
      curves: [{key: `${name}.goal`, colour: 'target', scale}, {key: `${name}.position`, colour: 'actual', scale}],
      least: 5}));
    this.node.replaceChildren(
      el('p', {className: 'key'}, ...this.legend()), el('div', {className: 'small-plots'}, ...this.plots.map((p) => p.node)));
  }

  legend() {
    const line = (name) => { const i = el('i'); i.style.background = `var(--${name})`; return i; };
    return [line('target'), 'target, ', line('actual'), 'actual, in degrees; each curve has its own height'];
  }

  restyle() { this.plots.forEach((plot) => plot.build()); }

  // Twenty plots in each frame would be too much for a small computer: a quarter of them each time. In a fifteenth of a
  // second such a small curve moves by a pixel.
  draw() {
    this.turn = (this.turn + 1) % 4;
    this.plots.forEach((plot, i) => i % 4 === this.turn && plot.draw());
  }

  update() {}
}
