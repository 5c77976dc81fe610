// Store, timeline and CSV export of the page, without a browser.
import assert from 'node:assert/strict';
import test from 'node:test';
import {columnsOf, fillRow} from '../../../window/page/src/columns.js';
import {csvOf} from '../../../window/page/src/csv.js';
import {Store} from '../../../window/page/src/store.js';
import {Timeline} from '../../../window/page/src/timeline.js';

const kJoints = [{name: 'Neck'}, {name: 'Head'}];

function stateAt(time, neck) {
  const two = (value) => [value, 0];
  return {time, cycle: Math.round(time / 0.016), joints: {goal: two(0.5), position: two(neck), speed: two(0), load: two(null),
    temperature: two(31), voltage: two(12)}, board: {accelerometer: [0, 0, 9.81], gyro: null, voltage: 12.1}};
}

function recorded(count, rows = 1000) {
  const columns = columnsOf(kJoints), store = new Store(columns, rows), row = new Float64Array(columns.length);
  for (let i = 0; i < count; ++i) {
    fillRow(row, stateAt(i * 0.016, i), kJoints.length);
    store.add(row);
  }
  return store;
}

test('unknown values are gaps in curves and empty CSV fields', () => {
  const store = recorded(3), load = [];
  store.read(store.index.get('Neck.load'), 0, 3, load);
  assert.deepEqual(load, [null, null, null]);
  const [head, first] = csvOf(store, [0, 0]).split('\n').map((line) => line.split(','));
  assert.equal(first[head.indexOf('Neck.load [1]')], '');
  assert.equal(first[head.indexOf('gyro.x [rad/s]')], '');
  assert.equal(first[head.indexOf('Head.position [rad]')], '0');
});

test('the store keeps the newest rows in constant memory', () => {
  const store = recorded(250, 100), position = [];
  assert.equal(store.count, 100);
  assert.equal(store.data[0].length, 100);
  store.read(store.index.get('Neck.position'), 0, 100, position);
  assert.deepEqual([position[0], position[99]], [150, 249]);
  assert.equal(store.find(200 * 0.016), 50);
});

test('a pause keeps its data while new rows arrive', () => {
  const timeline = new Timeline(), store = recorded(100, 100);
  timeline.restart(store);
  timeline.pause();
  const range = timeline.range, before = timeline.store.at(2, 0);
  const row = new Float64Array(store.columns.length).fill(99);
  for (let i = 0; i < 100; ++i) store.add(row);
  assert.deepEqual(timeline.range, range);
  assert.equal(timeline.store.at(2, 0), before);
  timeline.resume();
  assert.equal(timeline.range[1], 99);
});

test('a zoom pauses, and export saves only the range shown', () => {
  const timeline = new Timeline();
  timeline.restart(recorded(200));
  timeline.zoom(1.0, 1.5);
  assert.ok(timeline.paused);
  const times = csvOf(timeline.store, timeline.range).trim().split('\n').slice(1).map((line) => Number(line.split(',')[0]));
  assert.equal(times.length, 31);
  assert.ok(times.every((time) => time >= 1.0 && time <= 1.5));
});
