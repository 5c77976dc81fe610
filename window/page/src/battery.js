/// How the battery looks by the active faults: the robot's own thresholds may differ from those of the fault table.
export function batteryLook(active) {
  const names = active.map(({name}) => name);
  return names.includes('battery_empty') ? 'bad' : names.includes('battery_low') ? 'warn' : '';
}
