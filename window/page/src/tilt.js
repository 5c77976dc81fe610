// Estimates the trunk's up direction: complementary filter of gyro and accelerometer.
import {Quaternion, Vector3} from 'three';

import {kGravity} from './limits.js';

const kTimeConstant_s = 0.6;       // time constant of the filter
const kShaken = 0.35;          // relative deviation from gravity beyond which the accelerometer is ignored
const kLongestStep_s = 0.3;

export class Tilt {
  /// `sensors`: orientations of both sensors in the trunk, from body.json.
  constructor(sensors) {
    const axes = ([w, x, y, z]) => new Quaternion(x, y, z, w);
    this.accelerometer = axes(sensors.accelerometer.quat);
    this.gyro = axes(sensors.gyro.quat);
    this.up = new Vector3(0, 1, 0);  // in the trunk
    this.time = null;
    this.felt = new Vector3();
    this.rate = new Vector3();
  }

  take(time, accelerometer, gyro) {
    const step = this.time === null ? null : time - this.time;
    this.time = time;
    if (step !== null && (step < 0 || step > kLongestStep_s)) this.begin = true;
    if (known(gyro) && step > 0 && step <= kLongestStep_s) {
      this.rate.set(...gyro).applyQuaternion(this.gyro);
      this.up.addScaledVector(this.felt.crossVectors(this.rate, this.up), -step);
    }
    if (!known(accelerometer)) return;
    this.felt.set(...accelerometer).applyQuaternion(this.accelerometer);
    const strength = this.felt.length() / kGravity;
    if (Math.abs(strength - 1) > kShaken) return;
    const trust = step === null || this.begin ? 1 : Math.min(step / kTimeConstant_s, 1);
    this.begin = false;
    this.up.addScaledVector(this.felt.normalize().sub(this.up), trust).normalize();
  }
}

const known = (three) => Array.isArray(three) && three.every((value) => typeof value === 'number');
