// Validation of monitor messages (docs/monitor.md). Invalid messages, of a broken or hostile robot, are ignored.

const kMostJoints = 64, kMostNames = 1000, kLongest = 10000, kMostPixels = 4096;
const kGreatest = 1e15;  // larger values cannot be drawn

const text = (value) => typeof value === 'string' && value.length <= kLongest;
const number = (value) => typeof value === 'number' && Math.abs(value) <= kGreatest;
const flag = (value) => typeof value === 'boolean';
const unknownOr = (is) => (value) => value === null || value === undefined || is(value);
const list = (is, most, least = 0) => (value) =>
  Array.isArray(value) && value.length >= least && value.length <= most && value.every(is);
const shape = (members) => (value) =>
  typeof value === 'object' && value !== null && Object.entries(members).every(([name, is]) => is(value[name]));
const namesOf = (is) => (value) =>
  typeof value === 'object' && value !== null && Object.keys(value).length <= kMostNames && Object.values(value).every(is);

const figure = unknownOr(number), words = unknownOr(text);
const three = unknownOr(list(figure, 3, 3));
const each = list(figure, kMostJoints), flags = list(unknownOr(flag), kMostJoints);
const percentiles = unknownOr(namesOf(figure));

const kJoint = shape({name: text, meaning: words, chain: text, low: number, high: number, start: number});
const kPerJoint = {position: each, goal: each, speed: each, load: each, age: each, temperature: each, voltage: each,
  torque: flags, torque_limit: each, silent: flags};

const size = (value) => Number.isInteger(value) && value > 0 && value <= kMostPixels;
const orNone = (is) => (value) => value === null || is(value);
const kFound = shape({picture: number, width: size, height: size, x: orNone(number), y: orNone(number), pixels: number,
  percent: number, box: orNone(list(number, 4, 4))});
const isMask = ({mask, width, height}) => typeof mask === 'string' && /^[A-Za-z0-9+/]*={0,2}$/.test(mask) &&
  mask.length === 4 * Math.ceil((width + 7 >> 3) * height / 3);

const kShapes = {
  hello: shape({robot: words, port: words, runtime: words, period: figure, joints: list(kJoint, kMostJoints, 1)}),
  state: shape({cycle: number, time: number, state: words, joints: shape(kPerJoint),
    board: shape({accelerometer: three, gyro: three, voltage: figure})}),
  loop: shape({cycles: figure, overruns: figure, skipped: figure, retries: figure, incomplete: figure, bad_checksums: figure,
    reconnects: figure, lost: figure, session: figure, recent: unknownOr(shape({overruns: figure})),
    wake_us: percentiles, bus_ms: percentiles, slack_ms: percentiles, stale: unknownOr(list(text, kMostNames)), limit_hits: unknownOr(namesOf(number)),
    driver: unknownOr(shape({pid: figure})),
    wake_histogram: unknownOr(shape({edges_us: list(number, kMostNames), counts: list(number, kMostNames)}))}),
  faults: shape({active: list(shape({code: number, name: text, joint: words, meaning: text, remedy: text}), kMostNames)}),
  notice: shape({number, time: figure, text}),
  gone: shape({reason: text}),
  ended: shape({text}),
  camera: shape({seeing: flag, text: words}),
  found: (message) => kFound(message) && (message.x === null || (number(message.y) && message.box !== null)) &&
    (message.mask === undefined || isMask(message)),
  picture: () => false,  // binary only
};

/// Accepts unknown types, of later versions.
export function isMessage(message) {
  if (typeof message !== 'object' || message === null || !text(message.type)) return false;
  return !Object.hasOwn(kShapes, message.type) || kShapes[message.type](message);
}

/// Number of joints in a state; NaN: inconsistent.
export function jointsOf({joints}) {
  const count = joints.position.length;
  return Object.keys(kPerJoint).every((what) => joints[what].length === count) ? count : NaN;
}
