// Floor grid of 0.1 m. Short segments, because some software renderers drop long lines that start behind the camera.
import {BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments} from 'three';

const kCell = 0.1, kCells = 40;  // m; cells per side

export function floorLines() {
  const points = [];
  const half = (kCell * kCells) / 2;
  for (let line = 0; line <= kCells; ++line)
    for (let piece = 0; piece < kCells; ++piece) {
      const fixed = line * kCell - half, from = piece * kCell - half, to = from + kCell;
      points.push(from, fixed, 0, to, fixed, 0, fixed, from, 0, fixed, to, 0);
    }
  const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(points), 3));
  const lines = new LineSegments(geometry, new LineBasicMaterial({depthWrite: false}));
  lines.frustumCulled = false;
  return lines;
}

/// Moves the grid under the robot.
export function follow(lines, place) {
  lines.position.set(Math.round(place.x / kCell) * kCell, Math.round(place.y / kCell) * kCell, 0);
}
