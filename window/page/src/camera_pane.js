// Camera tab: picture and search result, requested only while the tab is visible.
import {ColourSearch} from './colour_search.js';
import {el, setText} from './dom.js';
import {FoundOverlay} from './found_overlay.js';
import {jpegSize} from './jpeg_size.js';
import {hueOf, resultText} from './search_text.js';

const kRate = 10;         // Hz
const kAskEvery_ms = 100; // sliders change more often; the channel accepts 50 messages a second
const kMaxUnsearched = 20;  // pictures without a search result before a message is shown
const kMaxResults = 4;      // kept
const kMostPixels = 4096; // width or height
const kAround = 2;        // pixels averaged around a click

export class CameraPane {
  constructor(feed) {
    this.feed = feed;
    this.visible = false;
    this.number = null;   // of the picture shown
    this.results = [];      // results precede their pictures
    this.unsearched = 0;
    this.canvas = el('canvas', {id: 'picture', width: 320, height: 240, role: 'img', ariaLabel: 'Camera picture'});
    this.context = this.canvas.getContext('2d', {willReadFrequently: true});
    this.overlay = new FoundOverlay();
    this.text = el('p', {className: 'note', id: 'picture-note'}, 'No picture yet.');
    this.result = el('p', {id: 'found-text'});
    this.search = new ColourSearch(() => this.askSoon());
    this.node = el('div', {className: 'pane camera-pane'},
      el('div', {}, el('div', {className: 'camera-view'}, this.canvas, this.overlay.node), this.result, this.text), this.search.node);
    this.canvas.addEventListener('click', (event) => this.pick(event));
    feed.addEventListener('picture', (event) => this.take(event.detail));
    feed.addEventListener('found', ({detail}) => this.takeResult(detail));
    feed.addEventListener('camera', ({detail}) => this.showReason(detail));
  }

  begin() {}
  restyle() {}
  draw() {}
  update() {}

  shown(yes) {
    this.visible = yes;
    this.ask();
  }

  ask() { this.feed.ask({camera: this.visible ? kRate : 0, find: this.search.request}); }

  askSoon() {
    this.timer ??= setTimeout(() => {
      this.timer = undefined;
      this.ask();
    }, kAskEvery_ms);
    if (this.search.request === null) this.forget('');
  }

  /// Discards results for the picture shown.
  forget(why) {
    this.results = [];
    this.unsearched = 0;
    this.overlay.clear();
    setText(this.result, why);
    this.canvas.ariaLabel = 'Camera picture';
  }

  showReason({seeing, text}) {
    if (seeing) return;
    setText(this.text, `No picture: ${text}`);
    this.context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    this.number = null;
    this.forget('');
  }

  async take(data) {
    const head = new DataView(data);
    if (data.byteLength < 20 || head.getUint8(0) !== 1) return;
    const jpeg = new Uint8Array(data).subarray(head.getUint8(1));
    if (!jpegSize(jpeg)?.every((pixels) => pixels > 0 && pixels <= kMostPixels)) return;
    const picture = await createImageBitmap(new Blob([jpeg], {type: 'image/jpeg'})).catch(() => null);
    if (!picture) return;  // damaged; the next one follows soon
    if (this.canvas.width !== picture.width) [this.canvas.width, this.canvas.height] = [picture.width, picture.height];
    this.context.drawImage(picture, 0, 0);
    picture.close();
    this.number = head.getUint32(8, true);
    setText(this.text, `${this.canvas.width} × ${this.canvas.height}, ${head.getUint32(12, true)} ms old when sent`);
    ++this.unsearched;
    this.overlay.clear();
    this.match();
  }

  takeResult(found) {
    this.results = [...this.results, found].slice(-kMaxResults);
    this.match();
  }

  /// Shows only the result of this picture.
  match() {
    if (this.search.request === null || this.number === null) return;
    const found = this.results.find(({picture}) => picture === this.number);
    if (found === undefined) {
      if (this.unsearched >= kMaxUnsearched) this.forget('No search result: the monitor on the robot is older than this window; update the robot.');
      return;
    }
    this.unsearched = 0;
    this.overlay.draw(found);
    const result = resultText(found, this.search.settings);
    setText(this.result, result);
    this.canvas.ariaLabel = `Camera picture. ${result}`;
  }

  /// Takes the hue at the clicked position.
  pick({offsetX, offsetY}) {
    if (this.number === null) return;
    const scale = this.canvas.width / this.canvas.clientWidth, size = 2 * kAround + 1;
    const {data} = this.context.getImageData(offsetX * scale - kAround, offsetY * scale - kAround, size, size);
    const sum = [0, 0, 0];
    for (let i = 0; i < data.length; ++i) if (i % 4 < 3) sum[i % 4] += data[i];
    const hue = hueOf(...sum);
    if (hue !== null) this.search.set({hue});
  }
}
