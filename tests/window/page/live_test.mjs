// Texts of the live comparison, without a browser.
import assert from 'node:assert/strict';
import test from 'node:test';
import {lossText, stateText} from '../../../window/page/src/live_text.js';

const kNone = {begin: 1, gap: 0, silence: 0, torque: 0, turned: 0, new_runtime: 0};
const kState = {runs: true, error: '', no_robot: '', state: 'comparing', resynced: 'begin', resyncs: kNone, cycles: 500, missing: 0,
  dropped: 0, gains_known: true, step_ms: null, period_ms: 16, window_s: 5, driven: [true, true, false], silent: [false, false, true]};

test('each state has a text of its own', () => {
  const texts = [null, {...kState, runs: false}, {...kState, error: 'my.ini, line 3'}, {...kState, no_robot: 'a reason'}, kState,
    ...['no_data', 'on_its_side', 'settling'].map((state) => ({...kState, state}))].map(stateText);
  assert.ok(texts.every((text) => text.length > 10), texts.join('; '));
  assert.equal(new Set(texts).size, texts.length);
  assert.match(texts[2], /my\.ini, line 3/);
  assert.match(texts[3], /a reason/);
  assert.match(texts[4], /\b2 joints.*\b1 silent/);
});

test('what was not compared is counted, and the text is empty where nothing was lost', () => {
  assert.equal(lossText(kState), '');
  assert.equal(lossText(null), '');
  assert.match(lossText({...kState, dropped: 125, missing: 130}), /\b125\b.*\b5\b/);
  assert.match(lossText({...kState, resyncs: {...kNone, gap: 2, turned: 1}, resynced: 'turned'}), /\b3\b/);
  assert.notEqual(lossText({...kState, gains_known: false}), '');
  assert.match(lossText({...kState, step_ms: 0.512}), /0\.51 ms/);
});
