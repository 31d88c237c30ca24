/**
 * Formats the AssemblyScript kernels with the project's formatter, which does not parse their decorators.
 * Without `--write` it only reports, as `npm run lint` does.
 */
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { hideDecorators, showDecorators } from './lib/kernel-decorators.mjs';
import { resolveInstalled, root } from './lib/paths.mjs';

const folders = ['packages/physics/kernels', 'bench/kernels'].filter((folder) => existsSync(join(root, folder)));
const names = folders.flatMap((folder) =>
  readdirSync(join(root, folder), { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.ts') && !name.endsWith('.test.ts'))
    .map((name) => join(folder, name)),
);
const copy = mkdtempSync(join(tmpdir(), 'principia-kernels-'));
try {
  for (const name of names) {
    mkdirSync(dirname(join(copy, name)), { recursive: true });
    writeFileSync(join(copy, name), hideDecorators(readFileSync(join(root, name), 'utf8')));
  }
  const config = { ...JSON.parse(readFileSync(`${root}/biome.json`, 'utf8')), vcs: { enabled: false }, overrides: [] };
  writeFileSync(join(copy, 'biome.json'), JSON.stringify(config));
  const biome = resolveInstalled('@biomejs/biome/bin/biome');
  const result = spawnSync(process.execPath, [biome, 'format', '--write', '.'], { cwd: copy, encoding: 'utf8' });
  if (result.status !== 0) throw new Error(result.stderr);
  finish(names.filter((name) => formatted(name) !== readFileSync(join(root, name), 'utf8')));
} finally {
  rmSync(copy, { recursive: true, force: true });
}

/** @param {string} name */
function formatted(name) {
  return showDecorators(readFileSync(join(copy, name), 'utf8'));
}

/** @param {string[]} different */
function finish(different) {
  const write = process.argv.includes('--write');
  for (const name of different) {
    if (write) writeFileSync(join(root, name), formatted(name));
    else process.stderr.write(`${name} is not formatted: run npm run format\n`);
  }
  if (different.length > 0 && !write) process.exitCode = 1;
}
