/** A vitest reporter that leaves the runner's own count, and what failed, in the file named by PRINCIPIA_TEST_COUNT. */
import { writeFileSync } from 'node:fs';

export default class CountReporter {
  /**
   * A file that cannot be loaded, a failing hook outside a test and an unhandled error count as one failure each.
   * @param {readonly import('vitest/node').TestModule[]} modules
   * @param {readonly { readonly message?: string }[]} unhandledErrors
   */
  onTestRunEnd(modules, unhandledErrors) {
    const count = { passed: 0, failed: unhandledErrors.length, skipped: 0 };
    /** Names of tests with the first line of their error. */
    const failures = unhandledErrors.map((error) => `outside of any test: ${firstLine(error)}`);
    /** Names of tests that passed only when they were tried again. */
    const unsteady = [];
    for (const module of modules) {
      for (const test of module.children.allTests()) {
        const { state, errors } = test.result();
        const name = `${module.relativeModuleId} > ${test.fullName}`;
        if (state === 'passed' || state === 'failed') count[state]++;
        else count.skipped++;
        if (state === 'failed') failures.push(`${name}: ${errors?.map(firstLine).join(' | ')}`);
        if (test.diagnostic()?.flaky) unsteady.push(`${name}: ${errors?.map(firstLine).join(' | ')}`);
      }
      for (const suite of [module, ...module.children.allSuites()]) {
        const errors = suite.errors();
        if (errors.length === 0) continue;
        count.failed++;
        failures.push(`${module.relativeModuleId}, outside of its tests: ${errors.map(firstLine).join(' | ')}`);
      }
    }
    const file = process.env.PRINCIPIA_TEST_COUNT;
    if (file) writeFileSync(file, JSON.stringify({ ...count, failures, unsteady }));
  }
}

/** @param {{ readonly message?: string }} error */
function firstLine({ message = '' }) {
  return message.split('\n', 1)[0].slice(0, 300);
}
