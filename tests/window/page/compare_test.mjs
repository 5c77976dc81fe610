// Recordings of the Compare tab, and the start pose; without a browser.
import assert from 'node:assert/strict';
import test from 'node:test';
import {LogFile} from '../../../window/page/src/log_file.js';
import {isSecure, poseFindings} from '../../../window/page/src/start_pose.js';

const file = (name, text) => Object.assign(new Blob([text]), {name});
const kRecording = '# darwinop recording 1\r\n# robot: x\r\ntime_s,cycle,Neck.position [rad],Neck.load\r\n' +
  '100.000,1,0.5,\r\n100.016,2,,0.1\r\n100.032,3,0.7,0.2\r\n# lost rows: 2\r\n100.080,6,0.9,0.2\r\n# end\r\n';

test('reads a recording by column, from its first row, with unknown values', async () => {
  const log = await LogFile.open(file('walk.csv', kRecording));
  assert.deepEqual(log.names, ['cycle', 'Neck.position', 'Neck.load']);
  assert.equal(log.unit('Neck.position'), 'rad');
  const {times, values, cut} = await log.read('Neck.position');
  assert.deepEqual(times.map((time) => Number(time.toFixed(3))), [0, 0.016, 0.032, 0.08]);
  assert.deepEqual(values, [0.5, null, 0.7, 0.9]);
  assert.equal(cut, false);
  assert.deepEqual((await log.read('Head.position')).times, []);
});

test('reads a CSV file of this page and drops an incomplete last row', async () => {
  const log = await LogFile.open(file('page.csv', 'time [s],cycle [1],Neck.goal [rad]\n1,1,0.1\n2,2,0.2\n3,3,0.'));
  assert.deepEqual((await log.read('Neck.goal')).values, [0.1, 0.2]);
});

test('rejects other files with a message', async () => {
  await assert.rejects(LogFile.open(file('a.csv', 'x,y\n1,2\n')), /a\.csv is not a recording: it has no column time_s/);
  await assert.rejects(LogFile.open(file('b.bin', 'x'.repeat(200000))), /b\.bin .*64 kB/);
  await assert.rejects(LogFile.open(file('c.csv', '')), /not a recording/);
});

test('reads long names as fast as short ones', async () => {
  const name = `a${' '.repeat(60000)}b`;
  assert.deepEqual((await LogFile.open(file('a.csv', `time_s,${name}\n`))).names, [name]);
});

const kLegs = [{name: 'LegLowerR', chain: 'right_leg', start: 2.25}, {name: 'Neck', chain: 'head', start: 0}];
const at = (knee, neck, felt) => ({joints: {position: [knee, neck]}, board: {accelerometer: felt}});

test('reports legs out of the start pose, unknown joints and a lying robot, but not arms and head', () => {
  const up = [0, 0, 9.8];
  assert.ok(isSecure(poseFindings(kLegs, at(2.0, 1.5, up))));
  assert.deepEqual(poseFindings(kLegs, at(1.25, 0, up)).off, [{name: 'LegLowerR', by: -1}]);
  assert.deepEqual(poseFindings(kLegs, at(null, 0, up)).off, [{name: 'LegLowerR', by: null}]);
  assert.equal(poseFindings(kLegs, at(2.25, 0, [9.8, 0, 0])).upright, false);
  assert.equal(poseFindings(kLegs, at(2.25, 0, null)).upright, null);
  assert.ok(!isSecure(poseFindings(kLegs, at(2.25, 0, null))));
});
