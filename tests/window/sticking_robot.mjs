// A window on a virtual robot in a stand whose right elbow sticks and whose right arm moves.
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {startProgram, startWindow} from './window_program.mjs';

const kPlain = readFileSync(new URL('../../twin/models/darwin-op.ini', import.meta.url), 'utf8');
const kSwing = `[experiment]
name  = swing
title = The right arm moves up and down
[setup]
trunk     = clamped
pose      = standing
ArmLowerR = -0.6 rad
ShoulderR = -0.4 rad
duration  = 3 s
[phase swing]
joints    = ArmLowerR, ShoulderR
goal      = sine
amplitude = 0.3 rad
frequency = 0.5 Hz
duration  = 250 s
[record]
joints = ArmLowerR, ShoulderR
`;

/// The window's program, with `folder` and `repaired`: the model with the friction that darwinop gap names in
/// gap_record_system_test, 0.1193 of 0.12.
export async function startStickingRobot() {
  const folder = mkdtempSync(join(tmpdir(), 'darwinop-live-'));
  const modelWith = (name, friction) => {
    const file = join(folder, name);
    writeFileSync(file, `${kPlain}\n[effect coulomb ArmLowerR]\nfriction = ${friction} N m\n`);
    return file;
  };
  writeFileSync(join(folder, 'swing.ini'), kSwing);
  process.env.DARWINOP_TWIN_CLAMP = '0 1 0';
  const shown = await startWindow('--robot', `twin:${modelWith('robot.ini', 0.12)}`);
  delete process.env.DARWINOP_TWIN_CLAMP;
  const name = shown.printed().match(/DARWINOP_RUNTIME_NAME=(\S+)/)[1];
  const driver = await startProgram('experiment', ['run', join(folder, 'swing.ini'), '--robot', 'runtime', '--no-record', '--yes'], /./,
    {DARWINOP_RUNTIME_NAME: name});
  return {...shown, folder, repaired: modelWith('repaired.ini', 0.1193), end: async () => {
    await driver.end();
    await shown.end();
    rmSync(folder, {recursive: true, force: true});
  }};
}

/// Waits until the comparison with this model fills its window.
export const compared = (page, model) => page.waitForFunction((wanted) => {
  const {state} = window.darwinop.live;
  return state.setting.model === wanted && state.compared * state.period_ms / 1000 > 1.2 * state.window_s;
}, model, {timeout: 120_000});
