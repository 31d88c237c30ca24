/**
 * Runs every scene in each JavaScript engine of this machine and compares the hashes of their final states: `npm run
 * engines`. Engines that are absent are named with what installs them on Debian.
 */
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { build } from 'esbuild';
import { bundleOptions } from './lib/bundle.mjs';
import { reportFailure } from './lib/report-failure.mjs';

/** @type {readonly (readonly [name: string, program: string, install: string, run: (program: string, file: string) => Promise<string> | string])[]} */
const ENGINES = [
  ['V8 (Node)', process.execPath, 'Node', printed],
  ['V8 (Chromium)', process.env.CHROMIUM ?? '/usr/bin/chromium', 'apt-get install chromium', inChromium],
  ['SpiderMonkey (Firefox)', '/usr/bin/firefox-esr', 'apt-get install firefox-esr', inFirefox],
  ['JavaScriptCore', '/usr/bin/jsc', 'apt-get install libjavascriptcoregtk-4.0-bin', printed],
];

const folder = mkdtempSync(join(tmpdir(), 'principia-engines-'));
try {
  const file = join(folder, 'entry.js');
  const entry = bundleOptions({ entryPoints: ['test/support/engine-entry.ts'], format: 'iife', outfile: file });
  await build({ ...entry, sourcemap: false });
  /** @type {Record<string, string> | undefined} */
  let expected;
  for (const [name, program, install, run] of ENGINES) {
    if (!existsSync(program)) {
      process.stdout.write(`${name}: absent (${install})\n`);
      continue;
    }
    const found = JSON.parse(await run(program, file));
    expected ??= found;
    const different = Object.keys(found).filter((scene) => found[scene] !== expected?.[scene]);
    const count = Object.keys(found).length;
    process.stdout.write(`${name}: ${count - different.length} of ${count} hashes equal ${different.join(', ')}\n`);
    if (different.length > 0) process.exitCode = 1;
  }
} catch (error) {
  await reportFailure(error);
} finally {
  rmSync(folder, { recursive: true, force: true });
}

/**
 * @param {string} program
 * @param {string} file
 */
function printed(program, file) {
  const { stdout, stderr, status } = spawnSync(program, [file], { encoding: 'utf8', maxBuffer: 1e8 });
  if (status !== 0) throw new Error(`${program} failed: ${stderr}`);
  return stdout;
}

/** @type {(program: string, file: string) => Promise<string>} */
function inChromium(program, file) {
  const args = ['--headless', '--no-sandbox', '--disable-gpu', `--user-data-dir=${join(folder, 'chromium')}`];
  return inBrowser(program, args, file);
}

/** @type {(program: string, file: string) => Promise<string>} */
function inFirefox(program, file) {
  writeFileSync(join(folder, 'user.js'), 'user_pref("datareporting.policy.dataSubmissionEnabled", false);\n');
  return inBrowser(program, ['--headless', '--no-remote', '--profile', folder], file);
}

/**
 * Opens a page that runs the bundle and posts its result.
 * @param {string} program
 * @param {readonly string[]} args
 * @param {string} file
 * @returns {Promise<string>}
 */
async function inBrowser(program, args, file) {
  const page = `<!doctype html><script>${readFileSync(file, 'utf8').replaceAll('</script', '<\\/script')}</script>`;
  /** @type {(text: string) => void} */
  let done = () => {};
  const result = new Promise((resolve) => {
    done = resolve;
  });
  const server = createServer((request, response) => {
    if (request.method !== 'POST') {
      response.setHeader('content-type', 'text/html').end(page);
      return;
    }
    let text = '';
    request.on('data', (part) => {
      text += part;
    });
    request.on('end', () => {
      response.end();
      done(text);
    });
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(undefined)));
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  const child = spawn(program, [...args, `http://127.0.0.1:${port}/`], { stdio: 'ignore' });
  try {
    const late = new Promise((_, reject) => {
      setTimeout(() => reject(new Error(`${program} gave no result within two minutes.`)), 120_000).unref();
    });
    return await Promise.race([result, late]);
  } finally {
    child.kill();
    server.closeAllConnections();
    server.close();
  }
}
