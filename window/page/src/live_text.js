// What the live comparison says about itself.

const kStates = {
  no_data: 'The robot’s board does not reply: nothing is compared.',
  on_its_side: 'The robot lies on its side, where a twin on the floor cannot be put: nothing is compared. Turn the robot, or choose the stand.',
  settling: 'The twin was put into the measured pose, or the robot moves to its start pose; comparing a second later.',
  failed: 'The simulation has stopped. Restart it, or choose another model.',
};
const kReasons = {begin: 'begin', gap: 'missing cycles', silence: 'the board was silent', torque: 'a joint got torque',
  turned: 'robot or twin fell or was turned', new_runtime: 'new runtime'};

export const kSupports = {clamped: 'Trunk in a stand', floor: 'Free on the floor'};
export const kSupportNotes = {
  clamped: 'The twin’s trunk is held in the air, in the direction that the accelerometer shows. On a robot that stands, what its legs carry is a residual.',
  floor: 'The twin stands free: after the first slip of a sole it drifts away from the robot. Residuals of the legs then do not show errors of the model.',
};

/// One sentence: does it compare, and if not, why. `state`: null without a connection.
export function stateText(state) {
  if (state === null) return 'No connection to the window’s program.';
  if (!state.runs) return 'Not running. It takes a twentieth of a processor core.';
  if (state.error) return `${kStates.failed} ${state.error}`;
  if (state.no_robot) return `No robot: ${state.no_robot}`;
  if (state.state !== 'comparing') return kStates[state.state] ?? '';
  const driven = state.driven.filter(Boolean).length, silent = state.silent.filter(Boolean).length;
  const joints = driven === 0 ? 'no joint has torque: only the sensors are compared' : `${driven} joints with torque`;
  return `Comparing: ${joints}${silent > 0 ? `, ${silent} silent` : ''}; rms over ${state.window_s} s.`;
}

/// Sentences about what was left out and what it costs; empty where there is nothing to say.
export function lossText(state) {
  if (state === null || !state.runs || state.cycles === 0) return '';
  const parts = [];
  const again = Object.values(state.resyncs).reduce((sum, count) => sum + count, 0) - state.resyncs.begin;
  if (state.dropped > 0) parts.push(`This computer is too slow: ${state.dropped} cycles were dropped. Close other programs.`);
  if (state.missing > state.dropped) parts.push(`${state.missing - state.dropped} cycles did not arrive.`);
  if (again > 0) parts.push(`Put into the measured pose ${again} times more, last: ${kReasons[state.resynced] ?? state.resynced}.`);
  if (!state.gains_known) parts.push('P gains are unknown over the network: joints whose controller changes them disagree.');
  if (state.step_ms !== null) parts.push(`Twin: ${state.step_ms.toFixed(2)} ms of processor time per cycle of ${state.period_ms} ms.`);
  return parts.join(' ');
}
