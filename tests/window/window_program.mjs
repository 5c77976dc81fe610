// Helpers: darwinop programs with a virtual robot, and a browser.
import {spawn} from 'node:child_process';
import {existsSync} from 'node:fs';
import {createRequire} from 'node:module';
import {message} from './messages.mjs';

const need = createRequire(`${process.env.DARWINOP_NPM}/`);
const {chromium} = need('playwright-core');
export const kAxe = need.resolve('axe-core/axe.min.js');

export async function startBrowser() {
  const program = ['/usr/bin/chromium-headless-shell', '/usr/bin/chromium'].find(existsSync);
  if (!program) throw new Error('no Chromium here; install the Debian package chromium-headless-shell');
  return chromium.launch({executablePath: program, args: ['--no-sandbox']});
}

/// Starts a darwinop program and waits until its output matches `ready`; returns {said(), printed(), end()}.
export async function startProgram(noun, words, ready, more = {}) {
  const program = spawn(`${process.env.DARWINOP_BIN}/darwinop-${noun}`, words,
    {stdio: ['ignore', 'pipe', 'pipe'], env: {...process.env, ...more}});
  let said = '', printed = '';
  const ended = new Promise((done) => program.once('exit', done));
  const found = new Promise((done) => program.stdout.on('data', (text) => {
    printed += text;
    if (ready.test(printed)) done(true);
  }));
  program.stderr.on('data', (text) => { said += text; });
  if (await Promise.race([found, ended]) !== true) throw new Error(`darwinop ${noun} ended: ${said}`);
  return {process: program, said: () => said, printed: () => printed, end: () => { program.kill('SIGTERM'); return ended; }};
}

/// Starts `darwinop window`, with its `url`. Retries if the runtime rejects the robot on a busy computer.
export async function startWindow(...words) {
  for (let tries = 1; ; ++tries) {
    try {
      const shown = await startProgram('window', words, /http:\S+\n/);
      return Object.assign(shown, {url: shown.printed().match(/http:\S+/)[0]});
    } catch (error) {
      if (tries === 4 || !error.message.includes(message('kCannotBeDriven', 'connect/messages.hpp'))) throw error;
    }
  }
}

/// Waits until the page drives; confirms the dialog of a robot whose data was late on a busy computer.
export async function takeRobot(page) {
  const driving = page.locator('body.driving');
  for (let tries = 1; !(await driving.isVisible()); ++tries) {
    if (tries > 10) throw new Error('the robot cannot be taken');
    await page.click('#take', {timeout: 1000}).catch(() => {});
    await driving.waitFor({timeout: 2000}).catch(() => {});
    if (await page.locator('#pose').isVisible()) await page.click('#pose-cancel');
  }
}
