// Elements in one line, and numbers as people read them.

export function el(tag, properties = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name in node) node[name] = value;
    else node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

/// What is not known is a dash, never a zero.
export function number(value, digits = 0) {
  if (value === null || value === undefined || Number.isNaN(value)) return '—';
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace('-', '') : text;  // no -0
}

/// A number with its unit; the unit goes with the number.
export function withUnit(value, digits, unit) {
  const text = number(value, digits);
  return text === '—' ? text : `${text} ${unit}`;
}

/// Writes only what has changed: the browser lays out the page again after every write.
export function setText(node, text) {
  if (node.textContent !== text) node.textContent = text;
}

export function setClass(node, name) {
  if (node.className !== name) node.className = name;
}

export const degrees = (rad) => (rad * 180) / Math.PI;

const colours = new Map();
export const kDark = matchMedia('(prefers-color-scheme: dark)');
kDark.addEventListener('change', () => colours.clear());  // before others that listen

/// The colour that the style sheet gives to --name, light or dark. Kept: to ask costs a layout of the page.
export function colour(name) {
  if (!colours.has(name))
    colours.set(name, getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim());
  return colours.get(name);
}
