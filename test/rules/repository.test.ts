import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { root } from '../../scripts/lib/paths.mjs';
import { expectNone, projectFiles, trackedFiles } from './sources.ts';

const isBinary = (path: string) => readFileSync(`${root}/${path}`).subarray(0, 8192).includes(0);

test('git knows the project', () => {
  expect(trackedFiles).toContain('package.json');
});

test('nothing generated or installed is committed', () => {
  const generated =
    /(^|\/)(node_modules|dist|coverage|test-results|\.cache)\/|^packages\/physics\/docs\/|\.gen\.ts$|\.wasm$|\.log$|\.tsbuildinfo$/;
  expectNone(
    'Generated files are made anew on every machine (git rm --cached …):',
    trackedFiles.filter((path) => generated.test(path)),
  );
});

test('no binary is committed, except pictures of the documentation and the games', () => {
  const violations = trackedFiles
    .filter((path) => !/^(docs\/.*\.png|games\/[\w-]+\/picture\.webp)$/.test(path))
    .filter(isBinary);
  expectNone('Binaries make every clone heavier for ever; keep the source that makes them:', violations);
});

test('no file speaks of one machine’s folders', () => {
  const local = /(?<![\w.-])\/(?:work|root|home|Users)\/|\bshared\/[\w-]+\.md/;
  const violations = projectFiles
    .filter((path) => !isBinary(path))
    .flatMap((path) =>
      readFileSync(`${root}/${path}`, 'utf8')
        .split('\n')
        .map((line, index) => (local.test(line) ? `${path}:${index + 1} ${line.trim().slice(0, 100)}` : ''))
        .filter(Boolean),
    );
  expectNone('Paths of one machine mean nothing on another; use paths from the root of the project:', violations);
});
