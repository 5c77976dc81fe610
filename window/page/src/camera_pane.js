// What the camera sees; asked for only while somebody looks.
import {el, setText} from './dom.js';

const kRate = 10;  // Hz

export class CameraPane {
  constructor(feed) {
    this.feed = feed;
    this.canvas = el('canvas', {id: 'picture', width: 320, height: 240, role: 'img', ariaLabel: 'Camera picture'});
    this.text = el('p', {className: 'note'}, 'No picture yet.');
    this.node = el('div', {className: 'pane'}, el('div', {}, this.canvas, this.text));
    feed.addEventListener('picture', (event) => this.take(event.detail));
    feed.addEventListener('camera', ({detail}) => setText(this.text, detail.seeing ? '' : `No picture: ${detail.text}`));
  }

  begin() {}
  restyle() {}
  draw() {}
  tell() {}
  shown(yes) { this.feed.ask({camera: yes ? kRate : 0}); }

  async take(data) {
    const head = new DataView(data);
    if (data.byteLength < 20 || head.getUint8(0) !== 1) return;
    const jpeg = new Blob([data.slice(head.getUint8(1))], {type: 'image/jpeg'});
    const picture = await createImageBitmap(jpeg).catch(() => null);
    if (!picture) return;  // damaged; the next one comes soon
    if (this.canvas.width !== picture.width) [this.canvas.width, this.canvas.height] = [picture.width, picture.height];
    this.canvas.getContext('2d').drawImage(picture, 0, 0);
    picture.close();
    setText(this.text, `${this.canvas.width} × ${this.canvas.height}, ${head.getUint32(12, true)} ms old when it was sent`);
  }
}
