// Reduces a PNG to the 256 most frequent colours: a third of the size.
import {deflateSync} from 'node:zlib';

const kColours = 256;

/// `page`: any browser page, used to decode the PNG.
export async function smallPng(page, png) {
  const {width, height, colours, pixels} = await page.evaluate(async ([base64, most]) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))]));
    const {width, height} = bitmap, pen = new OffscreenCanvas(width, height).getContext('2d');
    pen.drawImage(bitmap, 0, 0);
    const seen = new Map(), {data} = pen.getImageData(0, 0, width, height);
    const words = Array.from({length: width * height}, (_, i) => data[4 * i] << 16 | data[4 * i + 1] << 8 | data[4 * i + 2]);
    for (const word of words) seen.set(word, (seen.get(word) ?? 0) + 1);
    const colours = [];
    const parts = (word) => [word >> 16, word >> 8 & 255, word & 255];
    const apart = (a, b) => (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2;
    for (const [word] of [...seen].sort((a, b) => b[1] - a[1])) {
      if (colours.length === most) break;
      if (colours.every((one) => apart(one, parts(word)) > 24)) colours.push(parts(word));  // skips similar colours
    }
    const nearest = (word) => {
      let best = 0;
      colours.forEach((colour, i) => { if (apart(colour, parts(word)) < apart(colours[best], parts(word))) best = i; });
      return best;
    };
    for (const word of seen.keys()) seen.set(word, nearest(word));
    return {width, height, colours, pixels: words.map((word) => String.fromCharCode(seen.get(word))).join('')};
  }, [png.toString('base64'), kColours]);
  const rows = Buffer.alloc((width + 1) * height), all = Buffer.from(pixels, 'latin1');
  for (let y = 0; y < height; ++y) all.copy(rows, y * (width + 1) + 1, y * width, (y + 1) * width);
  const head = Buffer.from([0, 0, 0, 0, 0, 0, 0, 0, 8, 3, 0, 0, 0]);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', head), chunk('PLTE', Buffer.from(colours.flat())),
    chunk('IDAT', deflateSync(rows, {level: 9})), chunk('IEND', Buffer.alloc(0))]);
}

function chunk(type, data) {
  const named = Buffer.concat([Buffer.from(type), data]), ends = Buffer.alloc(8);
  ends.writeUInt32BE(data.length, 0);
  ends.writeUInt32BE(crc(named), 4);
  return Buffer.concat([ends.subarray(0, 4), named, ends.subarray(4)]);
}

function crc(bytes) {
  let sum = -1;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; ++bit) sum = sum >>> 1 ^ (sum & 1 ? 0xEDB88320 : 0);
  }
  return ~sum >>> 0;
}
