import type { TestProject } from 'vitest/node';
import { buildExamples } from '../../scripts/build-examples.mjs';
import { buildKernels } from '../../scripts/build-kernels.mjs';

/** Runs before the tests, and again before each run of watch mode, so that plain `npx vitest` works too. */
export async function setup(project: TestProject): Promise<void> {
  await buildGenerated();
  project.onTestsRerun(buildGenerated);
}

async function buildGenerated(): Promise<void> {
  await buildKernels();
  await buildExamples();
}
