import { configDefaults, defineConfig } from 'vitest/config';

/** Workspace packages are read from their TypeScript sources; nothing has to be built first except the kernels. */
const fromSource = {
  resolve: { conditions: ['principia-source'] },
  ssr: { resolve: { conditions: ['principia-source'], noExternal: [/^@principia\//] } },
};

export default defineConfig({
  test: {
    // Vitest leaves a core to nobody: half of a machine with two.
    maxWorkers: '100%',
    // Worlds of tests are often odd on purpose; the tests of the warnings listen to them.
    onConsoleLog: (log) => !log.startsWith('Principia: '),
    forceRerunTriggers: [...configDefaults.forceRerunTriggers, '**/packages/physics/kernels/**'],
    projects: [
      {
        ...fromSource,
        test: {
          name: 'unit',
          include: ['{packages,games,bench,test}/**/*.test.ts'],
          exclude: ['**/node_modules/**', '**/dist/**', 'test/browser/**'],
          globalSetup: ['test/support/kernels-setup.ts'],
          // Thousands of steps of a reference take seconds, and several times as long on a busy machine.
          testTimeout: 60_000,
        },
      },
      {
        ...fromSource,
        test: {
          name: 'browser',
          include: ['test/browser/**/*.test.ts'],
          globalSetup: ['test/support/kernels-setup.ts', 'test/support/chromium-setup.ts'],
          fileParallelism: false,
          // A busy machine may drop a frame or a pointer event; what fails twice is wrong.
          retry: 1,
          testTimeout: 120_000,
          hookTimeout: 120_000,
        },
      },
    ],
  },
});
