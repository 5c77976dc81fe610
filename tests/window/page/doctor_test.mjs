// Rows of the doctor's document, without a browser.
import assert from 'node:assert/strict';
import test from 'node:test';
import {batteryLook} from '../../../window/page/src/battery.js';
import {pieces, rowsOf} from '../../../window/page/src/doctor.js';

test('the battery is marked by its faults, whose thresholds robot.ini may raise', () => {
  assert.equal(batteryLook([{name: 'servo_hot'}]), '');
  assert.equal(batteryLook([{name: 'servo_hot'}, {name: 'battery_low'}]), 'warn');
  assert.equal(batteryLook([{name: 'battery_low'}, {name: 'battery_empty'}]), 'bad');
});

test('faults come first, then findings with a remedy, then what is fine, all in the doctor\'s words', () => {
  const rows = rowsOf({
    faults: [{name: 'chain_broken', what: 'a first thing', remedy: 'do this', evidence: '15 and 17 are silent'}],
    findings: [{part: 'computer', level: 'ok', what: 'clock'}, {part: 'port', level: 'warn', what: 'timer', remedy: 'echo 1'},
      {part: 'robot', level: 'fail', what: 'AnkleR is silent'},
      {part: 'robot', level: 'fail', what: '15 and 17 are silent'}],
  });
  assert.deepEqual(rows.faults, [{look: 'bad', what: 'a first thing', evidence: '15 and 17 are silent', remedy: 'do this'}]);
  assert.deepEqual(rows.findings, [{look: 'warn', what: 'timer', evidence: '', remedy: 'echo 1'},
    {look: 'bad', what: 'AnkleR is silent', evidence: '', remedy: ''}]);
  assert.deepEqual(rows.fine, ['clock']);
});

test('commands in a remedy are distinguished from its words', () => {
  assert.deepEqual(pieces('stop it; `sudo fuser -v /dev/ttyUSB0` lists the programs'),
    [{text: 'stop it; ', code: false}, {text: 'sudo fuser -v /dev/ttyUSB0', code: true}, {text: ' lists the programs', code: false}]);
  assert.deepEqual(pieces('do that'), [{text: 'do that', code: false}]);
});
