// A still picture of the robot as it is, and, as a ghost, as it starts.
import {AmbientLight, DirectionalLight, MeshLambertMaterial, PerspectiveCamera, Scene, WebGLRenderer} from 'three';
import {colour} from './dom.js';
import {RobotModel} from './robot_model.js';
import {Standing} from './standing.js';
import {Tilt} from './tilt.js';

const kWidth = 340, kHeight = 300;

export class PosePicture {
  constructor(canvas, body) {
    this.canvas = canvas;
    this.body = body;
  }

  draw(joints, state) {
    const renderer = new WebGLRenderer({canvas: this.canvas, antialias: true, alpha: true, preserveDrawingBuffer: true});
    renderer.setSize(kWidth, kHeight, false);
    const scene = new Scene(), camera = new PerspectiveCamera(30, kWidth / kHeight, 0.05, 20);
    const ghost_look = new MeshLambertMaterial({transparent: true, opacity: 0.4, depthWrite: false, color: colour('ghost')});
    const robot = new RobotModel(this.body), ghost = new RobotModel(this.body, ghost_look), tilt = new Tilt(this.body.sensors);
    joints.forEach(({name, start}, i) => {
      robot.setJoint(name, state.joints.position[i]);
      ghost.setJoint(name, start);
    });
    tilt.take(state.time, state.board.accelerometer, state.board.gyro);
    new Standing(robot).settle(tilt.up);
    ghost.trunk.position.copy(robot.trunk.position);
    ghost.trunk.quaternion.copy(robot.trunk.quaternion);
    const sun = new DirectionalLight(0xffffff, 2.2);
    sun.position.set(2, -1.5, 3);
    scene.add(new AmbientLight(0xffffff, 1.4), sun, robot.trunk, ghost.trunk);
    const at = robot.trunk.position;
    camera.up.set(0, 0, 1);
    camera.position.set(at.x + 0.85, at.y - 0.75, at.z + 0.25);
    camera.lookAt(at.x, at.y, at.z - 0.04);
    renderer.render(scene, camera);
    renderer.dispose();
  }
}
