// Reads a JPEG's size from its header before decoding: a small file may declare a size of gigabytes.

const kMark = 0xff, kStart = 0xd8, kScan = 0xda;
const isFrameHead = (kind) => kind >= 0xc0 && kind <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(kind);

/// [width, height], or null: not a JPEG, or truncated.
export function jpegSize(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.byteLength < 2 || view.getUint8(0) !== kMark || view.getUint8(1) !== kStart) return null;
  for (let at = 2; at + 9 <= view.byteLength;) {
    const kind = view.getUint8(at + 1), length = view.getUint16(at + 2);
    if (view.getUint8(at) !== kMark || kind === kScan || length < 2) return null;
    if (isFrameHead(kind)) return [view.getUint16(at + 7), view.getUint16(at + 5)];
    at += 2 + length;
  }
  return null;
}
