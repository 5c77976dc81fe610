// Checks whether the robot is in its start pose, with the bounds of safety.

const kTolerance = 0.3528;     // rad (230 ticks), legs only: arms and head are light
const kUpright = [0, 0, 9.80665];
const kLean = 9.80665 / 4;     // m/s2 on each axis

/// {off: [{name, by}], upright}; `by` in rad; null: unknown.
export function poseFindings(joints, state) {
  const off = [];
  joints.forEach(({name, chain, start}, i) => {
    if (!chain.endsWith('leg')) return;
    const is = state.joints.position[i];
    if (is === null) off.push({name, by: null});
    else if (Math.abs(is - start) > kTolerance) off.push({name, by: is - start});
  });
  const felt = state.board.accelerometer;
  const upright = Array.isArray(felt) && felt.every((axis) => axis !== null)
    ? felt.every((axis, i) => Math.abs(axis - kUpright[i]) <= kLean) : null;
  return {off, upright};
}

export const isSecure = ({off, upright}) => off.length === 0 && upright === true;
