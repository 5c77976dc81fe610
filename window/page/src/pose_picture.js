// Still image of the robot now and, in orange, in its start pose.
import {AmbientLight, DirectionalLight, MeshLambertMaterial, PerspectiveCamera, Scene, Vector3, WebGLRenderer} from 'three';
import {colour} from './dom.js';
import {RobotModel} from './robot_model.js';
import {Standing} from './standing.js';
import {Tilt} from './tilt.js';

const kWidth = 340, kHeight = 300;
const kBeside = 0.32;                   // m between the two
const kUpright = new Vector3(0, 1, 0);  // in the trunk

export class PosePicture {
  constructor(canvas, body) {
    this.canvas = canvas;
    this.body = body;
  }

  draw(joints, state) {
    const renderer = new WebGLRenderer({canvas: this.canvas, antialias: true, alpha: true, preserveDrawingBuffer: true});
    renderer.setSize(kWidth, kHeight, false);
    const scene = new Scene(), camera = new PerspectiveCamera(30, kWidth / kHeight, 0.05, 20);
    const ghost_look = new MeshLambertMaterial({transparent: true, opacity: 0.75, color: colour('ghost')});
    const robot = new RobotModel(this.body), ghost = new RobotModel(this.body, ghost_look), tilt = new Tilt(this.body.sensors);
    joints.forEach(({name, start}, i) => {
      robot.setJoint(name, state.joints.position[i]);
      ghost.setJoint(name, start);
    });
    tilt.take(state.time, state.board.accelerometer, state.board.gyro);
    new Standing(robot).settle(tilt.up);
    new Standing(ghost).settle(kUpright);
    ghost.trunk.position.y += kBeside;
    const sun = new DirectionalLight(0xffffff, 2.2);
    sun.position.set(2, -1.5, 3);
    scene.add(new AmbientLight(0xffffff, 1.4), sun, robot.trunk, ghost.trunk);
    const at = robot.trunk.position;
    camera.up.set(0, 0, 1);
    camera.position.set(at.x + 1.25, at.y + kBeside / 2 - 0.3, 0.45);
    camera.lookAt(at.x, at.y + kBeside / 2, 0.19);
    renderer.render(scene, camera);
    scene.traverse((node) => { node.geometry?.dispose(); node.material?.dispose(); });
    renderer.dispose();
  }
}
