import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { expect, it } from 'vitest';
import { bundleOptions } from '../../scripts/lib/bundle.mjs';

/** Bytes a step. */
interface Measured {
  readonly bodies: number;
  readonly allocated: number;
  readonly kept: number;
}

async function measure(): Promise<Measured> {
  const folder = mkdtempSync(join(tmpdir(), 'principia-'));
  try {
    const outfile = join(folder, 'steps.mjs');
    const entry = fileURLToPath(new URL('./steps.ts', import.meta.url));
    await build({ ...bundleOptions({}), platform: 'node', entryPoints: [entry], outfile, sourcemap: false });
    // Young space of 64 MB: no collection happens while the steps are measured, so what is used is what was allocated.
    const flags = ['--expose-gc', '--max-semi-space-size=64'];
    return JSON.parse(execFileSync(process.execPath, [...flags, outfile], { encoding: 'utf8' })) as Measured;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

it('steps keep nothing on the heap, and allocate nothing per body', { timeout: 60_000 }, async () => {
  const { bodies, allocated, kept } = await measure();
  // Less than one pointer (8 bytes) is kept: nothing is.
  expect(kept).toBeLessThan(8);
  // The least that can be allocated is a boxed number of 12 bytes: one a body would be three times this. What is left
  // are the times that forces are asked for, and the numbers that kernels are given.
  expect(allocated).toBeLessThan(bodies * 4);
});
