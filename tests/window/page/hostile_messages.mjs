// Valid messages of a robot with two joints, one of each type, and mutations.

const two = (value) => [value, 0];
export const kMessages = [
  {type: 'hello', protocol: 1, runtime: '1', robot: 'x', port: 'y', period: 0.016, joints: ['Neck', 'Head'].map((name) =>
    ({name, meaning: 'a joint', chain: 'head', low: -1, high: 1, start: 0}))},
  {type: 'state', cycle: 7, time: 1.5, state: 'driven',
    joints: {position: two(0.1), goal: two(null), speed: two(0), load: two(0), age: two(0), temperature: two(30),
      voltage: two(12), torque: [true, null], torque_limit: two(1), silent: [false, false]},
    board: {accelerometer: [0, 0, 9.8], gyro: null, voltage: 12}},
  {type: 'loop', cycles: 9, overruns: 0, recent: {overruns: 0}, wake_us: {p50: 1, p99: 2, max: 3}, bus_ms: {p50: 1},
    stale: ['Neck'], limit_hits: {speed: 1}, driver: {pid: null}, wake_histogram: {edges_us: [10, 20], counts: [1, 2, 3]}},
  {type: 'faults', active: [{code: 20, name: 'low battery', joint: null, meaning: 'it is low', remedy: 'charge it'}]},
  {type: 'notice', number: 1, time: null, text: 'it began'},
  {type: 'camera', seeing: true, text: ''},
  {type: 'gone', reason: 'it ended'},
  {type: 'ended', text: 'the link is lost.'},
  {type: 'found', picture: 3, width: 12, height: 2, x: 9, y: 1, pixels: 3, percent: 12.5, box: [0, 0, 9, 1], mask: btoa('\x00\xf2\x81\xf0')},
];

/// Random numbers in [0, 1), reproducible by seed.
export function rng(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

const odd = () => [null, undefined, true, -1, 1e308, Infinity, NaN, 0.5, '', 'hello', 'x'.repeat(20000), [], [[]], {}, {length: 3},
  Array(100).fill(0), {toString: 7}, '<b>x</b>', '__proto__'];

/// A copy with some members removed or replaced by invalid values.
export function spoilt(message, random) {
  const copy = structuredClone(message), pick = (list) => list[Math.floor(random() * list.length)];
  for (let times = 1 + Math.floor(random() * 3); times > 0; --times) {
    let at = copy;
    for (;;) {
      const name = pick(Object.keys(at));
      if (name === undefined) break;
      if (typeof at[name] === 'object' && at[name] !== null && random() < 0.7) { at = at[name]; continue; }
      if (name !== 'type' || random() < 0.2) at[name] = pick(odd());
      break;
    }
  }
  return copy;
}
