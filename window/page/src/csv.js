// The part that is shown, as a table for any spreadsheet. An empty field: not known.

export function csvOf(store, [from, to]) {
  const lines = [store.columns.map((column) => `${column.key} [${column.unit}]`).join(',')];
  for (let row = store.find(from); row < store.count && store.at(0, row) <= to; ++row) {
    if (Number.isNaN(store.at(1, row))) continue;  // a gap that the page itself put in
    lines.push(store.columns.map((_, i) => field(store.at(i, row), i)).join(','));
  }
  return lines.join('\n') + '\n';
}

function field(value, column) {
  if (Number.isNaN(value)) return '';
  return column < 2 ? String(value) : String(Number(value.toPrecision(7)));  // a float has seven digits
}

export function save(text, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], {type: 'text/csv'}));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
