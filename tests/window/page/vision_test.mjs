// Texts and masks of colour-search results.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {codeOf, forMask, hueOf, kBalls, resultText} from '../../../window/page/src/search_text.js';

const kRed = kBalls['Red ball'];

test('describes a ball and the reason for none', () => {
  const ball = {x: 160, y: 99, percent: 4.08, pixels: 3133, box: [130, 70, 191, 129]};
  assert.match(resultText(ball, kRed), /\(160, 99\), 4\.1 % .* 62 × 60 /);
  const none = {...ball, x: null, y: null};
  assert.match(resultText({...none, pixels: 0, percent: 0, box: null}, kRed), / 3 × 3 /);
  assert.match(resultText({...none, percent: 41.2}, kRed), / 41 % .* 30 %/);
  assert.match(resultText(none, {...kRed, minPercent: 5}), / 4\.1 % .* 5 %/);
});

test('writes the settings as a line for a controller', () => {
  assert.equal(codeOf(kBalls['Orange ball']),
    'managers::RobotisOp2VisionManager eyes{camera->getWidth(), camera->getHeight(), 28, 20, 50, 45, 0, 30};');
});

test('decodes a mask, the lowest bit is the leftmost pixel', () => {
  const seen = [];
  forMask({mask: btoa('\x00\xf2\x81\xf0'), width: 12, height: 2}, (x, y) => seen.push([x, y]));
  assert.deepEqual(seen, [[9, 0], [0, 1], [7, 1]]);
});

test('computes the hue, null for greys', () => {
  assert.deepEqual([[255, 0, 0], [255, 255, 0], [0, 255, 0], [0, 0, 255], [255, 0, 20], [9, 9, 9]].map((rgb) => hueOf(...rgb)),
    [0, 60, 120, 240, 355, null]);
});
