// Status texts of the monitor channel, without a browser.
import assert from 'node:assert/strict';
import {test} from 'node:test';

globalThis.WebSocket = class {
  send() {}
};
const {Feed} = await import('../../../window/page/src/feed.js');
const {kWindowEnded} = await import('../../../window/page/src/messages.js');

test('keeps the reason of the program\'s end until it reconnects', () => {
  const feed = new Feed('ws://nowhere');
  feed.socket.onopen();
  feed.take('{"type": "ended", "text": "the link is lost."}');
  assert.ok(feed.problem.text.includes(`${kWindowEnded}: the link is lost.`));
  feed.connected = false;
  assert.ok(feed.problem.text.includes(`${kWindowEnded}: the link is lost.`));
  feed.socket.onopen();
  assert.ok(!feed.problem.text.includes(kWindowEnded));
});
