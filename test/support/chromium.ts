/** Finds (or, on a bare Debian machine, installs) a Chromium and starts it with software WebGL and WebGPU. */
import { spawnSync } from 'node:child_process';
import { accessSync, constants, existsSync, readdirSync, readFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { delimiter, join } from 'node:path';
import { type Browser, chromium } from 'playwright-core';

/** One set that serves WebGL and WebGPU alike on a machine without a GPU (SwiftShader draws both). */
export const chromiumFlags: readonly string[] = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--enable-unsafe-webgpu',
  // Without a graphics card the processor paints a page's text and boxes sooner than it pretends to be a card that does.
  '--disable-gpu-rasterization',
  '--enable-features=Vulkan',
  '--use-vulkan=swiftshader',
  '--use-webgpu-adapter=swiftshader',
];

const commandNames = ['chromium', 'chromium-browser', 'google-chrome-stable', 'google-chrome', 'microsoft-edge'];
const applicationPaths = [
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  '/Applications/Chromium.app/Contents/MacOS/Chromium',
  'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
  'C:\\Program Files (x86)\\Microsoft\\Edge\\Application\\msedge.exe',
];

export type ChromiumSearch = {
  /** Install Debian's package when nothing is found and we are root. Default true. */
  install?: boolean;
  /** The environment to read, for tests. */
  env?: NodeJS.ProcessEnv;
};

/** The path of a Chromium: `CHROMIUM` or `PRINCIPIA_CHROMIUM`, then the system's, then Playwright's, then apt's. */
export function findChromium({ install = true, env = process.env }: ChromiumSearch = {}): string {
  const named = env.CHROMIUM || env.PRINCIPIA_CHROMIUM;
  if (named) {
    if (isExecutable(named)) return named;
    throw new Error(`CHROMIUM names ${named}, which is not a program that can be run: correct or unset the variable.`);
  }
  const found = findOnSystem(env) ?? findInPlaywrightCache(env);
  if (found) return found;
  if (install && canInstallWithApt()) {
    installWithApt();
    const installed = findOnSystem(env);
    if (installed) return installed;
  }
  throw new Error(
    'No Chromium was found for the browser tests: install one (Debian: apt-get install chromium; anywhere: ' +
      'npx playwright-core install chromium) or set CHROMIUM to the path of its program.',
  );
}

/** A fresh headless Chromium; close it in `afterAll`. Further flags come after the shared ones. */
export async function launchChromium(options: { args?: readonly string[] } = {}): Promise<Browser> {
  return chromium.launch({
    executablePath: findChromium({ install: false }), // the setup of the browser tests has tried
    headless: true,
    chromiumSandbox: false,
    args: [...chromiumFlags, ...(options.args ?? [])],
  });
}

function findOnSystem(env: NodeJS.ProcessEnv): string | undefined {
  const folders = (env.PATH ?? '').split(delimiter).filter(Boolean);
  const commands = commandNames.flatMap((name) => folders.map((folder) => join(folder, name)));
  return [...commands, ...applicationPaths].find(isExecutable);
}

function findInPlaywrightCache(env: NodeJS.ProcessEnv): string | undefined {
  const own = chromium.executablePath();
  if (own && isExecutable(own)) return own;
  const cache = env.PLAYWRIGHT_BROWSERS_PATH ?? join(homedir(), '.cache', 'ms-playwright');
  if (!existsSync(cache)) return undefined;
  const revisions = readdirSync(cache).filter((name) => /^chromium-\d+$/.test(name));
  return revisions
    .sort((a, b) => Number(b.slice(9)) - Number(a.slice(9)))
    .flatMap((name) => ['chrome-linux64', 'chrome-linux'].map((folder) => join(cache, name, folder, 'chrome')))
    .find(isExecutable);
}

function isExecutable(path: string): boolean {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/** Ubuntu's `chromium` package is a stub for snap, so only Debian proper counts. */
function canInstallWithApt(): boolean {
  if (process.getuid?.() !== 0 || !existsSync('/etc/os-release')) return false;
  return /^ID="?debian"?$/m.test(readFileSync('/etc/os-release', 'utf8'));
}

function installWithApt(): void {
  process.stderr.write('Installing Chromium with apt-get for the browser tests (once, about a minute)…\n');
  const env = { ...process.env, DEBIAN_FRONTEND: 'noninteractive' };
  for (const args of [
    ['update', '-q'],
    ['install', '-q', '-y', '--no-install-recommends', 'chromium'],
  ]) {
    const { status, stdout, stderr } = spawnSync('apt-get', args, {
      env,
      encoding: 'utf8',
      timeout: 300_000,
      maxBuffer: 1 << 26,
    });
    if (status !== 0) process.stderr.write(`apt-get ${args[0]} failed:\n${stdout}${stderr}\n`);
  }
}
