import { buildKernels } from '../../scripts/build-kernels.mjs';

/** Runs once before the tests, so that plain `npx vitest` works too. */
export async function setup(): Promise<void> {
  await buildKernels();
}
