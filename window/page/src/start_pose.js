// Checks whether the robot is in its start pose, with the bounds of safety. Legs only: arms and head are light.
import {kGravity, kOrientationTolerance, kStartTolerance} from './limits.js';

const kUpright = [0, 0, kGravity];

/// {off: [{name, by}], upright}; `by` in rad; null: unknown.
export function poseFindings(joints, state) {
  const off = [];
  joints.forEach(({name, chain, start}, i) => {
    if (!chain.endsWith('leg')) return;
    const is = state.joints.position[i];
    if (is === null) off.push({name, by: null});
    else if (Math.abs(is - start) > kStartTolerance) off.push({name, by: is - start});
  });
  const felt = state.board.accelerometer;
  const upright = Array.isArray(felt) && felt.every((axis) => axis !== null)
    ? felt.every((axis, i) => Math.abs(axis - kUpright[i]) <= kOrientationTolerance) : null;
  return {off, upright};
}

export const isSecure = ({off, upright}) => off.length === 0 && upright === true;
