// DOM helpers and number formatting.

export function el(tag, properties = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name in node) node[name] = value;
    else node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

/// Unknown values are a dash, never 0.
export function number(value, digits = 0) {
  if (value === null || value === undefined || Number.isNaN(value)) return '—';
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace('-', '') : text;  // no -0
}

/// A number with its unit; unknown values have no unit.
export function withUnit(value, digits, unit) {
  const text = number(value, digits);
  return text === '—' ? text : `${text} ${unit}`;
}

/// Writes only changes, because every write causes a layout.
export function setText(node, text) {
  if (node.textContent !== text) node.textContent = text;
}

export function setClass(node, name) {
  if (node.className !== name) node.className = name;
}

export const degrees = (rad) => (rad * 180) / Math.PI;

const colours = new Map();
export const kDark = matchMedia('(prefers-color-scheme: dark)');
kDark.addEventListener('change', () => colours.clear());  // before other listeners

/// Value of the CSS variable --name in the present colour scheme. Cached, because reading it causes a layout.
export function colour(name) {
  if (!colours.has(name))
    colours.set(name, getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim());
  return colours.get(name);
}
