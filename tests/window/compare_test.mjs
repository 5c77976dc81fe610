// Recordings that are compared, and the start pose: no browser needed.
import assert from 'node:assert/strict';
import test from 'node:test';
import {LogFile} from '../../window/page/src/log_file.js';
import {isSecure, poseFindings} from '../../window/page/src/start_pose.js';

const file = (name, text) => Object.assign(new Blob([text]), {name});
const kRecording = '# darwinop recording 1\r\n# robot: x\r\ntime_s,cycle,Neck.position [rad],Neck.load\r\n' +
  '100.000,1,0.5,\r\n100.016,2,,0.1\r\n100.032,3,0.7,0.2\r\n# lost rows: 2\r\n100.080,6,0.9,0.2\r\n# end\r\n';

test('a recording is read column by column, from its own beginning, and what is not known stays unknown', async () => {
  const log = await LogFile.open(file('walk.csv', kRecording));
  assert.deepEqual(log.names, ['cycle', 'Neck.position', 'Neck.load']);
  assert.equal(log.unit('Neck.position'), 'rad');
  const {times, values, cut} = await log.read('Neck.position');
  assert.deepEqual(times.map((time) => Number(time.toFixed(3))), [0, 0.016, 0.032, 0.08]);
  assert.deepEqual(values, [0.5, null, 0.7, 0.9]);
  assert.equal(cut, false);
  assert.deepEqual((await log.read('Head.position')).times, []);
});

test('a table of this page is read, too, and a row torn off at the end is left out', async () => {
  const log = await LogFile.open(file('page.csv', 'time [s],cycle [1],Neck.goal [rad]\n1,1,0.1\n2,2,0.2\n3,3,0.'));
  assert.deepEqual((await log.read('Neck.goal')).values, [0.1, 0.2]);
});

test('what is no recording is refused with a sentence', async () => {
  await assert.rejects(LogFile.open(file('a.csv', 'x,y\n1,2\n')), /a\.csv is not a recording: it has no column time_s/);
  await assert.rejects(LogFile.open(file('b.bin', 'x'.repeat(200000))), /longer than 64 kB/);
  await assert.rejects(LogFile.open(file('c.csv', '')), /not a recording/);
});

test('a name that is long is read as fast as a short one', async () => {
  const name = `a${' '.repeat(60000)}b`;
  assert.deepEqual((await LogFile.open(file('a.csv', `time_s,${name}\n`))).names, [name]);
});

const kLegs = [{name: 'LegLowerR', chain: 'right_leg', start: 2.25}, {name: 'Neck', chain: 'head', start: 0}];
const at = (knee, neck, felt) => ({joints: {position: [knee, neck]}, board: {accelerometer: felt}});

test('legs out of the start pose, an unknown joint and a robot that lies are told; arms and head are not', () => {
  const up = [0, 0, 9.8];
  assert.ok(isSecure(poseFindings(kLegs, at(2.0, 1.5, up))));
  assert.deepEqual(poseFindings(kLegs, at(1.25, 0, up)).off, [{name: 'LegLowerR', by: -1}]);
  assert.deepEqual(poseFindings(kLegs, at(null, 0, up)).off, [{name: 'LegLowerR', by: null}]);
  assert.equal(poseFindings(kLegs, at(2.25, 0, [9.8, 0, 0])).upright, false);
  assert.equal(poseFindings(kLegs, at(2.25, 0, null)).upright, null);
  assert.ok(!isSecure(poseFindings(kLegs, at(2.25, 0, null))));
});
