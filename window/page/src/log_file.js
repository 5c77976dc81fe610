// Reader of recordings (docs/logs.md) and CSV files saved by this page. Reads in chunks and keeps requested columns only.

export const kMostRows = 400000;       // 1 h 45 min at 16 ms
const kLongestLine = 64 * 1024;        // bytes; a row of a recording has 4 kB
const kLongestHead = 200;              // lines before the column names

export class LogFile {
  /// Throws an Error with a message if the file is not a recording.
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
    if (log.time < 0) throw new Error(`${file.name} is not a recording: it has no column time_s; see docs/logs.md`);
    return log;
  }

  get names() { return this.columns.map(({name}) => name).filter((name, i) => i !== this.time); }
  unit(name) { return this.columns.find((column) => column.name === name)?.unit ?? ''; }

  /// {times, values, cut}: s since the first row; null: unknown. `cut`: rows beyond kMostRows were dropped.
  async read(name) {
    const at = this.columns.findIndex((column) => column.name === name), times = [], values = [];
    if (at < 0) return {times, values, cut: false};
    let named = false, first = null;
    for await (const line of linesOf(this.file)) {
      if (line.startsWith('#') || line === '') continue;
      if (!named) { named = true; continue; }
      const fields = line.split(','), time = numberOf(fields[this.time]);
      if (time === null || (times.length > 0 && time - first <= times.at(-1))) continue;  // incomplete row, or a restarted clock
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

// Empty: unknown.
function numberOf(field) {
  if (field === undefined || field.trim() === '') return null;
  const value = Number(field);
  return Number.isFinite(value) ? value : null;
}

// Drops an unterminated last line, left by a program that was killed.
async function* linesOf(file) {
  const decoder = new TextDecoder();
  let rest = '';
  for await (const piece of piecesOf(file)) {
    const lines = (rest + decoder.decode(piece, {stream: true})).split('\n');
    rest = lines.pop();
    if (rest.length > kLongestLine) throw new Error(`${file.name} is not a recording: a line is longer than 64 kB`);
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
