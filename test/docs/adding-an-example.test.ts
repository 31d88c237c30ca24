// The example of docs/adding-an-example.md, as it stands there: checked by the strict compiler, run, and judged by its own
// figure. It is short, and no other file has to be edited for it.
import { beforeAll, describe, expect, it } from 'vitest';
import { importBundled, type PageFiles, typeErrorsOf, writeFilesOf } from '../support/page-files.ts';

const RUN = `
import { step } from '@principia/physics';
import example from 'COPY/packages/scenes/src/examples/ch17/dropped-ball';
const run = example.start();
for (let i = 0; i < example.duration / run.dt; i++) {
  step(run.world, run.dt);
  run.observe();
}
export const states = run.checkStates().map(({ state }) => state);
export const { faults } = run.world.faults;
`;

describe('docs/adding-an-example.md', () => {
  let written: PageFiles;
  beforeAll(() => {
    written = writeFilesOf('adding-an-example');
  });

  it('has one file of 25 to 45 lines', () => {
    expect(written.files).toHaveLength(1);
    const lines = written.files[0].code.trim().split('\n').length;
    expect(lines).toBeGreaterThanOrEqual(25);
    expect(lines).toBeLessThanOrEqual(45);
  });

  it('type-checks', () => expect(typeErrorsOf(written)).toBe(''), 60_000);

  it('runs, and its figure is right', async () => {
    const { states, faults } = await importBundled(written, RUN);
    expect([states, faults]).toEqual([['passed'], []]);
  });
});
