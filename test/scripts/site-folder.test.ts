/** A site takes the place of all that is in its folder, so only a former site, or nothing, may be there. */
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, realpathSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, relative } from 'node:path';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { root } from '../../scripts/lib/paths.mjs';
import { serviceWorker } from '../../scripts/lib/service-worker.mjs';
import { siteAddress, siteFolder } from '../../scripts/lib/site-folder.mjs';

let home: string;

beforeEach(() => {
  home = realpathSync(mkdtempSync(join(tmpdir(), 'principia-site-folder-')));
});
afterEach(() => rmSync(home, { recursive: true, force: true }));

function write(path: string, text: string): void {
  mkdirSync(dirname(join(home, path)), { recursive: true });
  writeFileSync(join(home, path), text);
}

function writeFormerSite(): void {
  const files = { 'index.html': 'page', 'cloth/main.js': 'script' };
  for (const [path, text] of Object.entries({ ...files, 'cloth/main.js.map': '{}', 'sw.js': serviceWorker(files) }))
    write(`site/${path}`, text);
}

test('a folder that is new, empty or a former site takes a site, with a slash at its end or without', () => {
  expect(siteFolder(join(home, 'new/one/'))).toBe(join(home, 'new/one'));
  expect(siteFolder(home)).toBe(home);
  writeFormerSite();
  expect(siteFolder(`${home}/site/`)).toBe(join(home, 'site'));
});

test('a path is relative to the working folder', () => {
  expect(siteFolder(relative(process.cwd(), join(home, 'site')))).toBe(join(home, 'site'));
});

test('a folder with a file that is of no site is refused, and the file named', () => {
  write('thesis/part/text.txt', 'years of work');
  expect(() => siteFolder(join(home, 'thesis'))).toThrow(/part\/text\.txt there is no file of a former site/);
  writeFormerSite();
  write('site/CNAME', 'example.org');
  expect(() => siteFolder(join(home, 'site'))).toThrow(/CNAME there is no file of a former site/);
  expect(() => siteFolder(join(home, 'site/CNAME'))).toThrow(/it is a file/);
});

test('a page that only looks like a site is refused', () => {
  write('own/index.html', 'page');
  write('own/sw.js', 'const FILES = ["index.html"];\n');
  expect(() => siteFolder(join(home, 'own'))).toThrow(/no file of a former site/);
});

test('the project, what holds it, and the folder one is in are refused', () => {
  expect(() => siteFolder(root)).toThrow(/the project lies there/);
  expect(() => siteFolder(`${root}/..`)).toThrow(/the project lies there/);
  expect(() => siteFolder(`${root}/docs`)).toThrow(/no file of a former site/);
  expect(() => siteFolder('')).toThrow(/lies there/);
  symlinkSync(root, join(home, 'link'));
  expect(() => siteFolder(join(home, 'link'))).toThrow(/the project lies there/);
});

test.each([
  [['--out', '.'], /the folder you are in lies there/],
  [['--url', 'nonsense'], /--url must be the address of the site/],
  [['--serve', '--port', '70000'], /--port must be a whole number from 0 to 65535, not "70000"/],
])('site %j ends with a sentence before anything is written', (args, sentence) => {
  write('thesis.txt', 'years of work');
  const { status, stderr, stdout } = spawnSync(process.execPath, [join(root, 'scripts/site.mjs'), ...args], {
    cwd: home,
    encoding: 'utf8',
  });
  expect([status, stdout]).toEqual([2, '']);
  expect(stderr).toMatch(sentence);
  expect(stderr.trimEnd()).not.toContain('\n');
  expect(readdirSync(home)).toEqual(['thesis.txt']);
});

test('a host that this machine does not have is said in a sentence', () => {
  const { status, stderr } = spawnSync(process.execPath, ['scripts/site.mjs', '--serve', '--host', '192.0.2.1'], {
    cwd: root,
    encoding: 'utf8',
  });
  expect(status).toBe(1);
  expect(stderr).toMatch(/^Nothing can be served at 192\.0\.2\.1 \(EADDRNOTAVAIL\): --host must be .*\.\n$/);
});

test('the address of a site ends with a slash, from which those of its games lead on', () => {
  for (const text of ['', '/', '/index.html'])
    expect(new URL('cloth/', siteAddress(`https://example.org/games${text}`)).href).toBe(
      'https://example.org/games/cloth/',
    );
  expect(siteAddress('https://example.org')).toBe('https://example.org/');
  for (const text of ['', 'games', 'ftp://example.org/', 'https://example.org/?a=1'])
    expect(() => siteAddress(text)).toThrow(/--url must be/);
});
