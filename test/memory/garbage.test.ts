import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { INTEGRATORS } from '@principia/physics';
import { build } from 'esbuild';
import { afterAll, describe, expect, it } from 'vitest';
import { bundleOptions } from '../../scripts/lib/bundle.mjs';

/** Bytes per step. */
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
  // With a young space of 64 MB no collection happens during the measurement, so the used size is what was allocated.
  // The compiler runs synchronously, because code that is not compiled yet allocates numbers on the heap.
  const flags = ['--expose-gc', '--max-semi-space-size=64', '--no-concurrent-recompilation'];
  return JSON.parse(execFileSync(process.execPath, [...flags, program, ...args], { encoding: 'utf8' })) as Measured;
}

it('steps keep nothing on the heap, and allocate nothing per body', { timeout: 60_000 }, async () => {
  const { bodies, allocated, kept } = measure(await bundled('steps'));
  // Less than one pointer (8 bytes) is kept: nothing is.
  expect(kept).toBeLessThan(8);
  // The smallest allocation is a boxed number of 12 bytes; one per body would be three times this limit. The remaining
  // allocations are times of force evaluations and arguments of kernels.
  expect(allocated).toBeLessThan(bodies * 4);
  expect(allocated).toBeLessThan(1024);
});

describe('a step of each integrator', async () => {
  const program = await bundled('integrators');

  it.each([...Object.keys(INTEGRATORS), 'xpbd'])('%s allocates no object per body', (name) => {
    const { allocated, kept } = measure(program, name);
    expect(kept).toBeLessThan(8);
    // A hundred bodies in 3D: less than one boxed number of 12 bytes each, for all evaluations and iterations.
    expect(allocated).toBeLessThan(1024);
  });
});
