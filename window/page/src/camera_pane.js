// What the camera sees, and what the vision manager finds in it; asked for only while somebody looks.
import {ColourSearch} from './colour_search.js';
import {el, setText} from './dom.js';
import {FoundOverlay} from './found_overlay.js';
import {jpegSize} from './jpeg_size.js';
import {hueOf, sentenceOf} from './search_words.js';

const kRate = 10;         // Hz
const kAskEvery_ms = 100; // a slider changes more often, and the channel takes 50 messages a second
const kPatience = 20;     // pictures in which nothing was looked for, and then it is said
const kFinds = 4;         // kept
const kMostPixels = 4096; // wide or high
const kAround = 2;        // pixels on each side of a click

export class CameraPane {
  constructor(feed) {
    this.feed = feed;
    this.visible = false;
    this.number = null;   // of the picture that is shown
    this.finds = [];      // in it and in pictures to come: what was found goes ahead of its picture
    this.unsearched = 0;
    this.canvas = el('canvas', {id: 'picture', width: 320, height: 240, role: 'img', ariaLabel: 'Camera picture'});
    this.context = this.canvas.getContext('2d', {willReadFrequently: true});
    this.overlay = new FoundOverlay();
    this.text = el('p', {className: 'note', id: 'picture-note'}, 'No picture yet.');
    this.sentence = el('p', {id: 'found-text'});
    this.search = new ColourSearch(() => this.askSoon());
    this.node = el('div', {className: 'pane eyes'},
      el('div', {}, el('div', {className: 'eye'}, this.canvas, this.overlay.node), this.sentence, this.text), this.search.node);
    this.canvas.addEventListener('click', (event) => this.pick(event));
    feed.addEventListener('picture', (event) => this.take(event.detail));
    feed.addEventListener('found', ({detail}) => this.takeFound(detail));
    feed.addEventListener('camera', ({detail}) => this.tellWhy(detail));
  }

  begin() {}
  restyle() {}
  draw() {}
  tell() {}

  shown(yes) {
    this.visible = yes;
    this.ask();
  }

  ask() { this.feed.ask({camera: this.visible ? kRate : 0, find: this.search.wish}); }

  askSoon() {
    this.timer ??= setTimeout(() => {
      this.timer = undefined;
      this.ask();
    }, kAskEvery_ms);
    if (this.search.wish === null) this.forget('');
  }

  /// Nothing is known of the picture that is shown.
  forget(why) {
    this.finds = [];
    this.unsearched = 0;
    this.overlay.clear();
    setText(this.sentence, why);
    this.canvas.ariaLabel = 'Camera picture';
  }

  tellWhy({seeing, text}) {
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
    if (!picture) return;  // damaged; the next one comes soon
    if (this.canvas.width !== picture.width) [this.canvas.width, this.canvas.height] = [picture.width, picture.height];
    this.context.drawImage(picture, 0, 0);
    picture.close();
    this.number = head.getUint32(8, true);
    setText(this.text, `${this.canvas.width} × ${this.canvas.height}, ${head.getUint32(12, true)} ms old when it was sent`);
    ++this.unsearched;
    this.overlay.clear();
    this.match();
  }

  takeFound(found) {
    this.finds = [...this.finds, found].slice(-kFinds);
    this.match();
  }

  /// Only what was found in this picture is shown over it.
  match() {
    if (this.search.wish === null || this.number === null) return;
    const found = this.finds.find(({picture}) => picture === this.number);
    if (found === undefined) {
      if (this.unsearched >= kPatience) this.forget('Nothing is looked for: the monitor on the robot is older than this window.');
      return;
    }
    this.unsearched = 0;
    this.overlay.draw(found);
    const sentence = sentenceOf(found, this.search.settings);
    setText(this.sentence, sentence);
    this.canvas.ariaLabel = `Camera picture. ${sentence}`;
  }

  /// The hue of what was clicked on.
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
