import { execFile } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, expect, test } from 'vitest';
import type { Result } from './result.ts';

const folder = mkdtempSync(join(tmpdir(), 'principia-bench-'));
afterAll(() => rmSync(folder, { recursive: true, force: true }));

function bench(...args: string[]): Promise<{ code: number; stdout: string; stderr: string }> {
  return new Promise((resolve) => {
    execFile(process.execPath, ['scripts/bench.mjs', ...args], (error, stdout, stderr) => {
      resolve({ code: error === null ? 0 : Number(error.code), stdout, stderr });
    });
  });
}

function resultOf(name: string): Result {
  return JSON.parse(readFileSync(join(folder, name), 'utf8'));
}

const small = ['particles', '--count', '2000', '--steps', '30'];

test('the result has the documented shape, and its hash knows nothing of peers or time', {
  timeout: 120_000,
}, async () => {
  const files = ['--json', join(folder, 'a.json'), '--html', join(folder, 'a.html')];
  const { code, stdout } = await bench(...small, '--peers', ...files);
  expect(code).toBe(0);
  expect(stdout).toContain('hand-fused SIMD kernel');
  const result = resultOf('a.json');
  expect(result).toMatchObject({ scene: 'particles', count: 2000, steps: 30, dimensions: 2, precision: 'f32' });
  expect(result.msPerStep.min).toBeLessThanOrEqual(result.msPerStep.median);
  expect(result.msPerStep.median).toBeLessThanOrEqual(result.msPerStep.p99);
  expect(result.nsPerBodyStep).toBeCloseTo((result.msPerStep.median * 1e6) / 2000, 6);
  for (const field of ['createMs', 'bytes', 'garbageBytesPerStep'] as const)
    expect(typeof result[field]).toBe('number');
  expect(result.hash).toMatch(/^[0-9a-f]{16}$/);
  expect(Number.isFinite(result.energyDrift)).toBe(true);
  expect(result.energyNote).toMatch(/drag|bounce|wall/);
  expect(result.profile).toHaveProperty('integrate');
  expect(result.peers.map(({ name }) => name)).toEqual([
    'hand-fused SIMD kernel',
    'hand-written loop',
    'fused by hand in plain JavaScript',
    'bitECS query idiom',
  ]);
  for (const { msPerStep, ratio } of result.peers) expect(ratio).toBeCloseTo(msPerStep / result.msPerStep.median, 9);
  expect(result.create.peers.map(({ name }) => name)).toEqual(['bare bitECS']);
  expect(readFileSync(join(folder, 'a.html'), 'utf8')).not.toMatch(/https?:\/\//);

  await bench(...small, '--warmup', '0', '--json', join(folder, 'b.json'));
  expect(resultOf('b.json').hash).toBe(result.hash);
  expect(resultOf('b.json').peers).toEqual([]);
});

test('a bad command line is one sentence, exit code 2, and no file', { timeout: 60_000 }, async () => {
  const file = join(folder, 'none.json');
  const { code, stdout, stderr } = await bench(...small, '--dimensions', '5', '--json', file);
  expect(code).toBe(2);
  expect(stdout).toBe('');
  expect(stderr.trim()).toBe('--dimensions must be 2 or 3, not "5".');
  expect(existsSync(file)).toBe(false);
});
