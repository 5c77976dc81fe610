// 3D view: measured pose in colour, commanded pose as a ghost.
import {
  AmbientLight, CircleGeometry, Color, DirectionalLight, Fog, Mesh, MeshBasicMaterial, MeshLambertMaterial,
  PerspectiveCamera, Scene, WebGLRenderer,
} from 'three';
import {colour} from './dom.js';
import {floorLines, follow} from './floor_lines.js';
import {kGraphicsCard} from './graphics.js';
import {Orbit} from './orbit.js';
import {Pace} from './pace.js';
import {RobotModel} from './robot_model.js';
import {Standing} from './standing.js';
import {Tilt} from './tilt.js';

const kSame_rad = 0.035;  // below this difference no ghost is shown
const kAgrees = new Color(0x0d5c30), kDisagrees = new Color(0xb81d10);
const kStill_rad = 5e-4;  // a third of a servo tick: no redraw

export class RobotView {
  constructor(canvas, body) {
    this.canvas = canvas;
    this.pace = new Pace();
    this.renderer = new WebGLRenderer({canvas, antialias: kGraphicsCard, alpha: true});
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, 0.05, 20);
    this.camera.up.set(0, 0, 1);
    this.orbit = new Orbit(canvas, this.camera);
    this.robot = new RobotModel(body);
    this.ghost_look = new MeshLambertMaterial({transparent: true, opacity: 0.28, depthWrite: false, fog: false});
    this.ghost = new RobotModel(body, this.ghost_look);
    this.ghost.trunk.visible = false;
    this.tilt = new Tilt(body.sensors);
    this.standing = new Standing(this.robot);
    const sun = new DirectionalLight(0xffffff, 2.2), fill = new DirectionalLight(0xffffff, 0.8);
    sun.position.set(2, -1.5, 3);
    fill.position.set(1, 3, 1);
    this.floor = new Mesh(new CircleGeometry(6, 48), new MeshBasicMaterial({depthWrite: false}));
    this.floor.renderOrder = -2;  // floor, then lines, then robot
    this.lines = floorLines();
    this.lines.renderOrder = -1;
    this.scene.add(new AmbientLight(0xffffff, 1.3), sun, fill, this.floor, this.lines, this.robot.trunk, this.ghost.trunk);
    this.paint();
    this.apart = new Set();
    this.changed = true;
    new ResizeObserver(() => { this.changed = true; }).observe(canvas);
  }

  /// Applies the present colour scheme.
  paint() {
    this.lines.material.color.set(colour('grid'));
    this.floor.material.color.set(colour('floor'));
    this.scene.fog = new Fog(colour('sky'), 1.2, 3.5);
    this.ghost_look.color.set(colour('ghost'));
    this.changed = true;
  }

  restart() { this.standing.reset(); }

  /// Colours joints by how much they disagree with the twin: 0 good, 1 bad, null not compared. `shares`: by name; null: no colours.
  tint(shares) {
    const key = shares === null ? '' : [...shares.values()].map((share) => share?.toFixed(1)).join();
    if (key === this.tinted) return;
    this.tinted = key;
    this.robot.tint(shares && new Map([...shares].map(([name, share]) => [name, share === null ? 0 : kAgrees.clone().lerp(kDisagrees, share)])));
    this.changed = true;
  }

  /// `joints`: of "hello"; `state`: newest "state" message.
  take(joints, state) {
    this.tilt.take(state.time, state.board.accelerometer, state.board.gyro);
    if (!this.moves(state)) return;
    this.apart.clear();
    joints.forEach(({name}, i) => {
      const is = state.joints.position[i], goal = state.joints.goal[i];
      this.robot.setJoint(name, is);
      this.ghost.setJoint(name, goal ?? is);
      if (is !== null && goal !== null && Math.abs(goal - is) > kSame_rad) this.apart.add(name);
    });
    this.standing.settle(this.tilt.up);
    this.ghost.trunk.position.copy(this.robot.trunk.position);
    this.ghost.trunk.quaternion.copy(this.robot.trunk.quaternion);
    this.ghost.trunk.visible = this.ghost.showOnly(this.apart);
    this.changed = true;
  }

  /// Whether this state differs visibly from the one drawn.
  moves({joints}) {
    const now = [...joints.position, ...joints.goal, ...this.tilt.up];
    const same = this.drawn && now.every((value, i) =>
      value === this.drawn[i] || (value !== null && this.drawn[i] !== null && Math.abs(value - this.drawn[i]) < kStill_rad));
    if (!same) this.drawn = now;
    return !same;
  }

  draw() {
    this.pace.frame();
    this.orbit.follow(this.robot.trunk.position);
    if ((!this.changed && !this.orbit.moved) || !this.pace.due()) return;
    const {clientWidth: width, clientHeight: height} = this.canvas;
    if (width === 0 || height === 0) return;
    if (this.width !== width || this.height !== height || this.pace.changed) {
      this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2) * this.pace.sharpness);
      this.renderer.setSize(width, height, false);
      this.pace.changed = false;
      this.camera.aspect = width / height;
      this.camera.updateProjectionMatrix();
      [this.width, this.height] = [width, height];
    }
    follow(this.lines, this.robot.trunk.position);
    follow(this.floor, this.robot.trunk.position);
    this.orbit.apply();
    this.renderer.render(this.scene, this.camera);
    this.changed = false;
  }
}
