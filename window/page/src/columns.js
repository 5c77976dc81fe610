// Columns stored for every state, with name and unit. NaN: unknown.

const kAxes = ['x', 'y', 'z'];
const kPerJoint = [
  ['goal', 'rad'], ['position', 'rad'], ['speed', 'rad/s'], ['load', '1'], ['temperature', 'degC'], ['voltage', 'V'],
];

/// [{key, unit}] in row order; `time` is first.
export function columnsOf(joints) {
  const columns = [{key: 'time', unit: 's'}, {key: 'cycle', unit: '1'}];
  for (const joint of joints)
    for (const [what, unit] of kPerJoint) columns.push({key: `${joint.name}.${what}`, unit});
  for (const axis of kAxes) columns.push({key: `accelerometer.${axis}`, unit: 'm/s2'});
  for (const axis of kAxes) columns.push({key: `gyro.${axis}`, unit: 'rad/s'});
  columns.push({key: 'board.voltage', unit: 'V'});
  return columns;
}

const known = (value) => (typeof value === 'number' ? value : NaN);

/// Writes the row of a "state" message into `row`.
export function fillRow(row, state, joints) {
  let at = 0;
  row[at++] = state.time;
  row[at++] = state.cycle;
  for (let i = 0; i < joints; ++i)
    for (const [what] of kPerJoint) row[at++] = known(state.joints[what]?.[i]);
  for (const sensor of ['accelerometer', 'gyro'])
    for (let i = 0; i < 3; ++i) row[at++] = known(state.board[sensor]?.[i]);
  row[at++] = known(state.board.voltage);
}
