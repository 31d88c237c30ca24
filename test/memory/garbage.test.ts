import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { INTEGRATORS } from '@principia/physics';
import { build } from 'esbuild';
import { afterAll, describe, expect, it } from 'vitest';
import { bundleOptions } from '../../scripts/lib/bundle.mjs';

/** Bytes a step. */
interface Measured {
  readonly bodies: number;
  readonly allocated: number;
  readonly kept: number;
}

const folder = mkdtempSync(join(tmpdir(), 'principia-'));
afterAll(() => rmSync(folder, { recursive: true }));

async function bundled(name: string): Promise<string> {
  const outfile = join(folder, `${name}.mjs`);
  const entry = fileURLToPath(new URL(`./${name}.ts`, import.meta.url));
  await build({ ...bundleOptions({}), platform: 'node', entryPoints: [entry], outfile, sourcemap: false });
  return outfile;
}

function measure(program: string, ...args: string[]): Measured {
  // Young space of 64 MB: no collection happens while the steps are measured, so what is used is what was allocated.
  // The compiler works at once and not when a core is free: what it has not compiled makes numbers on the heap.
  const flags = ['--expose-gc', '--max-semi-space-size=64', '--no-concurrent-recompilation'];
  return JSON.parse(execFileSync(process.execPath, [...flags, program, ...args], { encoding: 'utf8' })) as Measured;
}

it('steps keep nothing on the heap, and allocate nothing per body', { timeout: 60_000 }, async () => {
  const { bodies, allocated, kept } = measure(await bundled('steps'));
  // Less than one pointer (8 bytes) is kept: nothing is.
  expect(kept).toBeLessThan(8);
  // The least that can be allocated is a boxed number of 12 bytes: one a body would be three times this. What is left
  // are the times that forces are asked for, and the numbers that kernels are given.
  expect(allocated).toBeLessThan(bodies * 4);
  expect(allocated).toBeLessThan(1024);
});

describe('a step of each integrator', async () => {
  const program = await bundled('integrators');

  it.each([...Object.keys(INTEGRATORS), 'xpbd'])('%s makes no object a body', (name) => {
    const { allocated, kept } = measure(program, name);
    expect(kept).toBeLessThan(8);
    // Of a hundred bodies in space: less than one boxed number of 12 bytes each, for all evaluations and iterations.
    expect(allocated).toBeLessThan(1024);
  });
});
