// Arbitrary messages and files, without a browser: accepted values are in range, others are ignored, nothing throws
// uncaught. Reproducible.
import assert from 'node:assert/strict';
import test from 'node:test';
import {jpegSize} from '../../../window/page/src/jpeg_size.js';
import {LogFile} from '../../../window/page/src/log_file.js';
import {forMask, kBalls, resultText} from '../../../window/page/src/search_text.js';
import {isMessage, jointsOf} from '../../../window/page/src/shapes.js';
import {rng, kMessages, spoilt} from './hostile_messages.mjs';

test('accepts valid messages', () => {
  for (const message of kMessages) assert.ok(isMessage(message), JSON.stringify(message));
  assert.ok(isMessage({type: 'of a later version', what: [1, {}]}));
});

test('rejects messages of another shape', () => {
  const [hello, state, loop] = kMessages;
  for (const message of [null, 7, 'hello', [], {}, {type: 7}, {type: 'picture'}, {...hello, joints: null}, {...hello, joints: []},
    {...hello, joints: [{...hello.joints[0], name: {}}]}, {...state, time: null}, {...state, joints: undefined},
    {...state, board: null}, {...state, time: 1e300}, {...state, joints: {...state.joints, position: ['0', 0]}},
    {...loop, stale: 'all'}, {...loop, wake_histogram: {edges_us: [1], counts: null}}, {type: 'gone'}])
    assert.equal(isMessage(message), false, JSON.stringify(message));
  assert.ok(Number.isNaN(jointsOf({joints: {...state.joints, goal: []}})));
});

test('mutated messages never yield a number that cannot be drawn', () => {
  const random = rng(1);
  let understood = 0;
  for (let i = 0; i < 20000; ++i) {
    const message = spoilt(kMessages[i % kMessages.length], random);
    if (!isMessage(message)) continue;
    ++understood;
    if (message?.type === 'found') {
      assert.match(resultText(message, kBalls['Red ball']), /^(B|No b)all/);
      if (message.mask !== undefined) forMask(message, (x, y) => assert.ok(x < message.width && y < message.height));
    }
    if (message?.type !== 'state') continue;
    const values = [message.time, ...message.joints.position, ...message.joints.goal, ...(message.board.gyro ?? [])];
    assert.ok(values.every((value) => value === null || value === undefined || Math.abs(value) <= 1e15), JSON.stringify(message));
  }
  assert.ok(understood > 1000, `${understood} of them were harmless`);
});

test('arbitrary bytes as a recording: columns of numbers with rising times, or an error', async () => {
  const random = rng(2), below = (n) => Math.floor(random() * n);
  const good = '# darwinop recording 1\r\ntime_s,cycle,Neck.position [rad]\r\n1.0,1,0.5\r\n1.016,2,\r\n1.032,3,0.7\r\n';
  const words = ['time_s', 'time', ',', '\n', '\r\n', '#', '[', ']', '1e999', '-', '0x10', 'NaN', '"', '\0', '\ufeff', '9'.repeat(400)];
  let read = 0;
  for (let i = 0; i < 3000; ++i) {
    let bytes = Buffer.from(good);
    for (let times = 1 + below(6); times > 0; --times) {
      const at = below(bytes.length + 1), more = random() < 0.5 ? Buffer.from(words[below(words.length)])
        : Buffer.from(Array.from({length: below(8)}, () => below(256)));
      bytes = Buffer.concat([bytes.subarray(0, at), more, bytes.subarray(at + below(6))]);
    }
    const file = Object.assign(new Blob([bytes]), {name: 'any.csv'});
    const log = await LogFile.open(file).catch((error) => { assert.match(error.message, /^any\.csv is not a recording/); });
    for (const name of log?.names ?? []) {
      const {times, values} = await log.read(name);
      ++read;
      assert.equal(times.length, values.length);
      assert.ok(times.every((time, n) => Number.isFinite(time) && (n === 0 || time > times[n - 1])), bytes.toString());
      assert.ok(values.every((value) => value === null || Number.isFinite(value)), bytes.toString());
    }
  }
  assert.ok(read > 1000, `${read} columns were read`);
});

test('reads the size of a JPEG before it is decoded', () => {
  const jpeg = Uint8Array.from([0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 2, 0xff, 0xc0, 0, 17, 8, 0, 240, 1, 64, 3]);
  assert.deepEqual(jpegSize(jpeg), [320, 240]);
  for (let length = 0; length < 17; ++length) assert.equal(jpegSize(jpeg.subarray(0, length)), null, `${length} bytes`);
  for (const [at, byte] of [[0, 0], [2, 0], [5, 1], [9, 0xda]]) {
    const spoilt = jpeg.slice();
    spoilt[at] = byte;
    assert.equal(jpegSize(spoilt), null);
  }
  const random = rng(3);
  for (let i = 0; i < 20000; ++i) {
    const any = Uint8Array.from({length: Math.floor(random() * 40)}, () => Math.floor(random() * 256));
    const size = jpegSize(i % 2 ? Uint8Array.from([0xff, 0xd8, 0xff, ...any]) : any);
    assert.ok(size === null || size.length === 2);
  }
});
