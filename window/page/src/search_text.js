// Settings and result texts of the colour search.

/// In the constructor's order; docs/vision.md.
export const kSettings = [
  {name: 'hue', text: 'Hue', least: 0, most: 360, unit: '°'},
  {name: 'hueTolerance', text: 'Hue tolerance', least: 0, most: 180, unit: '°'},
  {name: 'minSaturation', text: 'Minimum saturation', least: -1, most: 100, unit: '%'},
  {name: 'minValue', text: 'Minimum value', least: -1, most: 100, unit: '%'},
  {name: 'minPercent', text: 'Minimum share of the picture', least: 0, most: 100, unit: '%'},
  {name: 'maxPercent', text: 'Maximum share of the picture', least: 0, most: 100, unit: '%'},
];

/// Presets of docs/vision.md and of the example controllers.
export const kBalls = {
  'Orange ball': {hue: 28, hueTolerance: 20, minSaturation: 50, minValue: 45, minPercent: 0, maxPercent: 30},
  'Red ball': {hue: 355, hueTolerance: 15, minSaturation: 60, minValue: 15, minPercent: 0, maxPercent: 30},
};

/// The constructor call for a controller.
export function codeOf(settings) {
  const values = kSettings.map(({name}) => settings[name]).join(', ');
  return `managers::RobotisOp2VisionManager eyes{camera->getWidth(), camera->getHeight(), ${values}};`;
}

const part = (percent) => `${percent < 10 ? percent.toFixed(1) : Math.round(percent)} %`;

export function resultText(found, {minPercent, maxPercent}) {
  const {x, y, percent, box} = found;
  if (x !== null) {
    const [left, top, right, bottom] = box;
    return `Ball at (${x}, ${y}), ${part(percent)} of the picture, in ${right - left + 1} × ${bottom - top + 1} pixels.`;
  }
  if (found.pixels === 0) return 'No ball: no area of this colour is at least 3 × 3 pixels.';
  if (percent >= maxPercent) return `No ball: ${part(percent)} of the picture has this colour, at least the maximum of ${maxPercent} %.`;
  return `No ball: ${part(percent)} of the picture has this colour, at most the minimum of ${minPercent} %.`;
}

/// Calls `each(x, y)` for every pixel in a message's mask.
export function forMask({mask, width, height}, each) {
  const bytes = atob(mask), row = (width + 7) >> 3;
  for (let y = 0; y < height; ++y)
    for (let i = 0; i < row; ++i) {
      const bits = bytes.charCodeAt(y * row + i);
      for (let bit = 0; bits >> bit; ++bit) if (bits >> bit & 1 && 8 * i + bit < width) each(8 * i + bit, y);
    }
}

/// Hue in degrees; null for greys.
export function hueOf(red, green, blue) {
  const most = Math.max(red, green, blue), range = most - Math.min(red, green, blue);
  if (range === 0) return null;
  const sixth = most === red ? (green - blue) / range : most === green ? 2 + (blue - red) / range : 4 + (red - green) / range;
  return (Math.round(60 * sixth) + 360) % 360;
}
