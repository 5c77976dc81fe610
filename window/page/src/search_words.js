// The colour that the vision manager looks for: its settings, and what it found, in words.

/// In the constructor's order; docs/vision.md.
export const kSettings = [
  {name: 'hue', text: 'Hue', least: 0, most: 360, unit: '°'},
  {name: 'hueTolerance', text: 'Hue tolerance', least: 0, most: 180, unit: '°'},
  {name: 'minSaturation', text: 'Least saturation', least: -1, most: 100, unit: '%'},
  {name: 'minValue', text: 'Least value', least: -1, most: 100, unit: '%'},
  {name: 'minPercent', text: 'Least part of the picture', least: 0, most: 100, unit: '%'},
  {name: 'maxPercent', text: 'Greatest part of the picture', least: 0, most: 100, unit: '%'},
];

/// Those of docs/vision.md and of the example controllers.
export const kBalls = {
  'Red ball': {hue: 355, hueTolerance: 15, minSaturation: 60, minValue: 15, minPercent: 0, maxPercent: 30},
  'Orange ball': {hue: 28, hueTolerance: 20, minSaturation: 50, minValue: 45, minPercent: 0, maxPercent: 30},
};

/// A line for a controller.
export function codeOf(settings) {
  const values = kSettings.map(({name}) => settings[name]).join(', ');
  return `managers::RobotisOp2VisionManager eyes{camera->getWidth(), camera->getHeight(), ${values}};`;
}

const part = (percent) => `${percent < 10 ? percent.toFixed(1) : Math.round(percent)} %`;

export function sentenceOf(found, {minPercent, maxPercent}) {
  const {x, y, percent, box} = found;
  if (x !== null) {
    const [left, top, right, bottom] = box;
    return `Ball at (${x}, ${y}), ${part(percent)} of the picture, in ${right - left + 1} × ${bottom - top + 1} pixels.`;
  }
  if (found.pixels === 0) return 'No ball: nothing of this colour is three pixels wide and high.';
  if (percent >= maxPercent) return `No ball: ${part(percent)} of the picture has this colour, and ${maxPercent} % is too much.`;
  return `No ball: ${part(percent)} of the picture has this colour, and ${minPercent} % is too little.`;
}

/// Calls `each` with x and y of every pixel in the mask of a message.
export function forMask({mask, width, height}, each) {
  const bytes = atob(mask), row = (width + 7) >> 3;
  for (let y = 0; y < height; ++y)
    for (let i = 0; i < row; ++i) {
      const bits = bytes.charCodeAt(y * row + i);
      for (let bit = 0; bits >> bit; ++bit) if (bits >> bit & 1 && 8 * i + bit < width) each(8 * i + bit, y);
    }
}

/// Hue of a colour in degrees, or null: greys have none.
export function hueOf(red, green, blue) {
  const most = Math.max(red, green, blue), range = most - Math.min(red, green, blue);
  if (range === 0) return null;
  const sixth = most === red ? (green - blue) / range : most === green ? 2 + (blue - red) / range : 4 + (red - green) / range;
  return (Math.round(60 * sixth) + 360) % 360;
}
