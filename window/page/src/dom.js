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
  return value === null || value === undefined || Number.isNaN(value) ? '—' : value.toFixed(digits);
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

/// The colour that the style sheet gives to --name, light or dark.
export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
