// The real program with a virtual robot, and a real browser.
import {spawn} from 'node:child_process';
import {existsSync} from 'node:fs';
import {createRequire} from 'node:module';
import {createInterface} from 'node:readline';

const need = createRequire(`${process.env.DARWINOP_NPM}/`);
const {chromium} = need('playwright-core');
export const kAxe = need.resolve('axe-core/axe.min.js');

export async function startBrowser() {
  const program = ['/usr/bin/chromium-headless-shell', '/usr/bin/chromium'].find(existsSync);
  if (!program) throw new Error('no Chromium here; install the Debian package chromium-headless-shell');
  return chromium.launch({executablePath: program, args: ['--no-sandbox']});
}

/// {url, process, end()}: `darwinop window` with these arguments, ready.
export async function startWindow(...words) {
  const program = spawn(`${process.env.DARWINOP_BIN}/darwinop-window`, words, {stdio: ['ignore', 'pipe', 'pipe']});
  let said = '';
  program.stderr.on('data', (text) => { said += text; });
  const ended = new Promise((done) => program.once('exit', done));
  for await (const line of createInterface({input: program.stdout})) {
    const url = line.match(/http:\S+/)?.[0];
    if (url) return {url, process: program, said: () => said, end: () => { program.kill('SIGTERM'); return ended; }};
  }
  throw new Error(`darwinop window ended: ${said}`);
}
