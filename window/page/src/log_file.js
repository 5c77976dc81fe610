// A recording (docs/logs.md) or a table saved by this page, read in pieces: only the columns that are asked for are kept.

export const kMostRows = 400000;       // an hour and three quarters at 16 ms
const kLongestLine = 64 * 1024;        // bytes; a row of a recording has 4 kB
const kLongestHead = 200;              // lines before the names

export class LogFile {
  /// Throws an Error with a sentence when it is no such file.
  static async open(file) {
    const log = new LogFile();
    log.file = file;
    log.name = file.name;
    let lines = 0;
    for await (const line of linesOf(file)) {
      if (++lines > kLongestHead) break;
      if (line.startsWith('#') || line === '') continue;
      log.columns = line.split(',').map(columnOf);
      break;
    }
    log.time = log.columns?.findIndex(({name}) => name === 'time_s' || name === 'time') ?? -1;
    if (log.time < 0) throw new Error(`${file.name} is no recording: it has no column time_s. See docs/logs.md`);
    return log;
  }

  get names() { return this.columns.map(({name}) => name).filter((name, i) => i !== this.time); }
  unit(name) { return this.columns.find((column) => column.name === name)?.unit ?? ''; }

  /// {times, values, cut}: s since the first row; null where nothing is known. `cut`: it has more rows than are kept.
  async read(name) {
    const at = this.columns.findIndex((column) => column.name === name), times = [], values = [];
    if (at < 0) return {times, values, cut: false};
    let named = false, first = null;
    for await (const line of linesOf(this.file)) {
      if (line.startsWith('#') || line === '') continue;
      if (!named) { named = true; continue; }
      const fields = line.split(','), time = numberOf(fields[this.time]);
      if (time === null || (times.length > 0 && time - first <= times.at(-1))) continue;  // torn, or a clock that began anew
      if (times.length === kMostRows) return {times, values, cut: true};
      first ??= time;
      times.push(time - first);
      values.push(numberOf(fields[at]));
    }
    return {times, values, cut: false};
  }
}

// "Neck.position [rad]"
function columnOf(text) {
  const whole = text.trim(), at = whole.endsWith(']') ? whole.indexOf('[') : -1;
  return at < 0 ? {name: whole, unit: ''} : {name: whole.slice(0, at).trimEnd(), unit: whole.slice(at + 1, -1)};
}

// Empty: not known.
function numberOf(field) {
  if (field === undefined || field.trim() === '') return null;
  const value = Number(field);
  return Number.isFinite(value) ? value : null;
}

// What has no end of line was torn off with the program that wrote it.
async function* linesOf(file) {
  const decoder = new TextDecoder();
  let rest = '';
  for await (const piece of piecesOf(file)) {
    const lines = (rest + decoder.decode(piece, {stream: true})).split('\n');
    rest = lines.pop();
    if (rest.length > kLongestLine) throw new Error(`${file.name} is no recording: its lines do not end`);
    for (const line of lines) yield line.endsWith('\r') ? line.slice(0, -1) : line;
  }
}

async function* piecesOf(file) {
  const reader = file.stream().getReader();
  try {
    for (;;) {
      const {done, value} = await reader.read();
      if (done) return;
      yield value;
    }
  } finally {
    reader.cancel().catch(() => {});
  }
}
