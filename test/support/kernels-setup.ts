import type { TestProject } from 'vitest/node';
import { buildKernels } from '../../scripts/build-kernels.mjs';

/** Runs before the tests, and again before each run of watch mode, so that plain `npx vitest` works too. */
export async function setup(project: TestProject): Promise<void> {
  await buildKernels();
  project.onTestsRerun(async () => {
    await buildKernels();
  });
}
