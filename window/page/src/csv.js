// CSV export of the time range shown. Empty field: unknown.

export function csvOf(store, [from, to]) {
  const lines = [store.columns.map((column) => `${column.key} [${column.unit}]`).join(',')];
  for (let row = store.find(from); row < store.count && store.at(0, row) <= to; ++row) {
    if (Number.isNaN(store.at(1, row))) continue;  // gap marker of the page
    lines.push(store.columns.map((_, i) => field(store.at(i, row), i)).join(','));
  }
  return lines.join('\n') + '\n';
}

function field(value, column) {
  if (Number.isNaN(value)) return '';
  return column < 2 ? String(value) : String(Number(value.toPrecision(7)));  // precision of a 32-bit float
}

export function save(text, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], {type: 'text/csv'}));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
