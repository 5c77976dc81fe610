// What the page says of its channel to the robot, without a browser.
import assert from 'node:assert/strict';
import {test} from 'node:test';

globalThis.WebSocket = class {
  send() {}
};
const {Feed} = await import('../../window/page/src/feed.js');

test('why the program has ended is said also when its channel closes, until it is there again', () => {
  const feed = new Feed('ws://nowhere');
  feed.socket.onopen();
  feed.take('{"type": "ended", "text": "the link is lost."}');
  assert.match(feed.problem.text, /has ended: the link is lost\./);
  feed.connected = false;
  assert.match(feed.problem.text, /has ended: the link is lost\./);
  feed.socket.onopen();
  assert.doesNotMatch(feed.problem.text, /has ended/);
});
