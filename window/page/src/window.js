// Main module of the robot window: connects channels, store and tabs.
import {CameraPane} from './camera_pane.js';
import {columnsOf, fillRow} from './columns.js';
import {ComparePane} from './compare_pane.js';
import {CurvesPane} from './curves_pane.js';
import {kDark, setClass, setText} from './dom.js';
import {Doctor} from './doctor.js';
import {FaultsPane} from './faults_pane.js';
import {Feed} from './feed.js';
import {LimbDrag} from './limb_drag.js';
import {Live} from './live.js';
import {LivePane} from './live_pane.js';
import {LoopPane} from './loop_pane.js';
import {Pills} from './pills.js';
import {PoseDialog} from './pose_dialog.js';
import {RobotView} from './robot_view.js';
import {SensorsPane} from './sensors_pane.js';
import {ServosPane} from './servos_pane.js';
import {SteerBar} from './steer_bar.js';
import {Steering} from './steering.js';
import {SteerPane} from './steer_pane.js';
import {kMinutesKept, Store} from './store.js';
import {Tabs} from './tabs.js';
import {TimeBar} from './time_bar.js';
import {Timeline} from './timeline.js';
import {Transfer} from './transfer.js';
import {TransferPane} from './transfer_pane.js';

const kRate = 62.5;        // Hz, rate of a 16 ms loop
const kGap_s = 0.25;       // gap in curves if states are further apart
const kFigures_ms = 200;   // update interval of numbers
const by = (id) => document.getElementById(id);

const channel = (name) => new URL(name, location.href.replace(/^http/, 'ws'));
const feed = new Feed(channel('monitor'));
const steering = new Steering(channel('steering'));
const steer = new SteerPane(steering);
const timeline = new Timeline();
const pills = new Pills(by('pills'));
const faults = new FaultsPane((active) => { pills.faults(active); tabs.count(5, active.length); });
const loop = new LoopPane();
const servos = new ServosPane(timeline, new Doctor(channel('doctor')));
const live = new Live(channel('live'));
const compare = new ComparePane(new LivePane(live, (shares) => view?.tint(shares)));
const panes = [
  {name: 'Servos', pane: servos}, {name: 'All curves', pane: new CurvesPane(timeline)},
  {name: 'Motion sensors', pane: new SensorsPane(timeline)}, {name: 'Steer', pane: steer}, {name: 'Loop', pane: loop},
  {name: 'Faults', pane: faults}, {name: 'Camera', pane: new CameraPane(feed)}, {name: 'Compare', pane: compare},
  {name: 'Transfer', pane: new TransferPane(new Transfer(channel('transfer')))},
];
let shown = servos, view = null, shape = null, joints = [], row = null, newest = null, marks = [];
const tabs = new Tabs(by('tabs'), by('stage'), panes, (pane) => {
  shown = pane;
  by('time').hidden = !pane.timed;  // only for tabs with curves
  update();
});
const fresh = () => (feed.problem === null ? newest : null);
const pose = new PoseDialog(() => ({joints, state: fresh(), body: shape}), () => steering.take());
new SteerBar(by('steer'), steering, () => pose.ask());
new TimeBar(by('time'), timeline, () => `darwinop-${new Date().toISOString().slice(0, 19).replace(/[:T]/g, '-')}.csv`);

feed.addEventListener('hello', ({detail}) => {
  faults.forget();
  setText(by('robot'), detail.robot ?? 'DARwIn-OP');
  document.title = `${detail.robot ?? 'DARwIn-OP'}, robot window`;
  by('robot').title = [detail.port, detail.runtime].filter(Boolean).join(', ');
  if (joints.length > 0) {
    if (JSON.stringify(joints) !== JSON.stringify(detail.joints)) location.reload();  // another robot
    return;
  }
  joints = detail.joints;
  begin();
  for (const {pane} of panes) pane.begin(joints);
});

function begin() {
  const columns = columnsOf(joints);
  timeline.restart(new Store(columns, Math.ceil(kRate * 60 * kMinutesKept), timeline.live));
  row = new Float64Array(columns.length);
  view?.restart();
}

feed.addEventListener('state', ({detail}) => {
  if (joints.length === 0) return;
  const before = timeline.live.newest;
  if (detail.time < before) begin();  // restarted runtime: new clock
  else if (detail.time - before > kGap_s) addGap(before);
  fillRow(row, detail, joints.length);
  timeline.live.add(row);
  view?.take(joints, detail);
  newest = detail;
  const now = performance.now();
  marks.push(now);
  while (marks[0] < now - 1000) marks.shift();
});

function addGap(time) {
  row.fill(NaN);
  row[0] = time + 1e-3;
  timeline.live.add(row);
}

feed.addEventListener('loop', ({detail}) => { loop.take(detail); pills.loop(detail); });
feed.addEventListener('faults', ({detail}) => faults.take(detail));
feed.addEventListener('notice', ({detail}) => faults.notice(detail));
feed.addEventListener('gone', () => pills.nothing());

// Goal or position of a joint.
function goalOf(name) {
  const i = joints.findIndex((joint) => joint.name === name), now = fresh();
  return now === null || i < 0 ? null : now.joints.goal[i] ?? now.joints.position[i];
}

function update() {
  const problem = feed.problem, banner = by('banner');
  banner.hidden = problem === null;
  setText(banner, problem?.text ?? '');
  setClass(banner, problem?.mild ? 'warn' : '');
  document.body.classList.toggle('stale', problem !== null);
  if (problem !== null && !problem.mild) pills.nothing();
  else if (newest) pills.state(newest, marks.length);
  if (newest && problem === null) for (const {pane} of panes) if (pane === shown) pane.update(newest);
}
setInterval(update, kFigures_ms);

const frames = {count: 0, since: performance.now()};  // for measurements: window.darwinop.frames
function frame() {
  view?.draw();
  shown.draw();
  ++frames.count;
  requestAnimationFrame(frame);
}
requestAnimationFrame(frame);

kDark.addEventListener('change', () => {
  view?.paint();
  for (const {pane} of panes) pane.restyle();
});

fetch('body.json').then((answer) => answer.json()).then((body) => {
  shape = body;
  view = new RobotView(by('view'), body);
  new LimbDrag(view, steering, goalOf, (name, angle) => steer.aim(name, angle));
  setText(by('pose-note'), 'Position is estimated from the standing foot, lean from accelerometer and gyro.');
}).catch((error) => setText(by('pose-note'), `No 3D view: ${error.message}`));

window.darwinop = {frames, timeline, feed, steering, compare, live, get view() { return view; }, get newest() { return newest; }};
