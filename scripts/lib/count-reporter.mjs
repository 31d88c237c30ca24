/** A vitest reporter that leaves the runner's own count in the file named by PRINCIPIA_TEST_COUNT. */
import { writeFileSync } from 'node:fs';

export default class CountReporter {
  /**
   * A file that cannot be loaded, a failing hook outside a test and an unhandled error count as one failure each.
   * @param {readonly import('vitest/node').TestModule[]} modules
   * @param {readonly unknown[]} unhandledErrors
   */
  onTestRunEnd(modules, unhandledErrors) {
    const count = { passed: 0, failed: unhandledErrors.length, skipped: 0 };
    for (const module of modules) {
      for (const test of module.children.allTests()) {
        const { state } = test.result();
        if (state === 'passed' || state === 'failed') count[state]++;
        else count.skipped++;
      }
      for (const suite of [module, ...module.children.allSuites()]) count.failed += suite.errors().length > 0 ? 1 : 0;
    }
    const file = process.env.PRINCIPIA_TEST_COUNT;
    if (file) writeFileSync(file, JSON.stringify(count));
  }
}
