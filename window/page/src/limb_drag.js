// Dragging a limb in the 3D view moves its joint while the page drives.
import {Raycaster, Vector2, Vector3} from 'three';

const kTurn = 0.009;  // rad per pixel

export class LimbDrag {
  /// `aim(name, rad)` returns the angle within the limits.
  constructor(view, steering, goalOf, aim) {
    this.view = view;
    this.steering = steering;
    this.goalOf = goalOf;
    this.aim = aim;
    this.held = null;
    const {canvas} = view;
    canvas.addEventListener('pointerdown', (event) => this.take(event), {capture: true});
    canvas.addEventListener('pointermove', (event) => this.move(event), {capture: true});
    for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => { this.held = null; });
  }

  /// The joint of the link under the pointer, or null.
  jointAt(event) {
    const box = this.view.canvas.getBoundingClientRect(), ray = new Raycaster();
    ray.setFromCamera(new Vector2(((event.clientX - box.left) / box.width) * 2 - 1,
      1 - ((event.clientY - box.top) / box.height) * 2), this.view.camera);
    const [hit] = ray.intersectObject(this.view.robot.trunk, true);
    for (let node = hit?.object.parent; node; node = node.parent) {
      const name = this.view.robot.jointOf(node);
      if (name) return {name, node};
      if (node === this.view.robot.trunk) return null;
    }
    return null;
  }

  take(event) {
    if (!this.steering.drives) return;
    const found = this.jointAt(event), angle = found && this.goalOf(found.name);
    if (!found || angle === null) return;
    event.stopImmediatePropagation();  // does not rotate the view
    this.view.canvas.setPointerCapture(event.pointerId);
    this.held = {...found, angle, at: [event.clientX, event.clientY], turn: this.across(found)};
  }

  // Screen direction in which a point in front of the joint moves when the joint turns.
  across({name, node}) {
    const {axis} = this.view.robot.joints.get(name);
    const centre = node.getWorldPosition(new Vector3());
    const pole = axis.clone().transformDirection(node.matrixWorld);
    const eye = this.view.camera.position.clone().sub(centre).normalize();
    const way = pole.clone().cross(eye);
    if (way.length() < 0.3) return new Vector2(1, 0);  // view along the axis: use left and right
    const flat = (point) => point.clone().project(this.view.camera);
    const moved = flat(centre.clone().addScaledVector(way, 0.05)).sub(flat(centre));
    return new Vector2(moved.x, -moved.y).normalize();
  }

  move(event) {
    if (!this.held) return;
    event.stopImmediatePropagation();
    const {at, turn} = this.held;
    const by = (event.clientX - at[0]) * turn.x + (event.clientY - at[1]) * turn.y;
    this.held.at = [event.clientX, event.clientY];
    this.held.angle = this.aim(this.held.name, this.held.angle + by * kTurn);
  }
}
