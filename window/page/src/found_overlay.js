// Overlay of a search result: matching pixels, bounding ellipse and centre.
import {el} from './dom.js';
import {forMask} from './search_text.js';

const kTint = [255, 0, 255, 150];  // magenta, absent from typical scenes

export class FoundOverlay {
  constructor() {
    this.node = el('canvas', {id: 'found', width: 320, height: 240, ariaHidden: 'true'});
    this.context = this.node.getContext('2d');
  }

  clear() { this.context.clearRect(0, 0, this.node.width, this.node.height); }

  draw(found) {
    if (this.node.width !== found.width) this.node.width = found.width;
    if (this.node.height !== found.height) this.node.height = found.height;
    this.clear();
    if (found.mask !== undefined) this.tint(found);
    if (found.x !== null) this.mark(found);
  }

  tint(found) {
    const image = this.context.createImageData(found.width, found.height);
    forMask(found, (x, y) => image.data.set(kTint, 4 * (y * found.width + x)));
    this.context.putImageData(image, 0, 0);
  }

  /// White on black: visible on any background.
  mark({x, y, box: [left, top, right, bottom]}) {
    const {context} = this;
    context.beginPath();
    context.ellipse((left + right + 1) / 2, (top + bottom + 1) / 2, (right - left + 1) / 2 + 2, (bottom - top + 1) / 2 + 2,
      0, 0, 2 * Math.PI);
    for (const [dx, dy] of [[7, 0], [0, 7]]) {
      context.moveTo(x + 0.5 - dx, y + 0.5 - dy);
      context.lineTo(x + 0.5 + dx, y + 0.5 + dy);
    }
    for (const [width, colour] of [[3.5, '#000000'], [1.5, '#ffffff']]) {
      context.lineWidth = width;
      context.strokeStyle = colour;
      context.stroke();
    }
  }
}
