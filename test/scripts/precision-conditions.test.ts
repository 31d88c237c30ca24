import { build } from 'esbuild';
import { expect, test } from 'vitest';
import { bundleOptions } from '../../scripts/lib/bundle.mjs';

const physics = "'./packages/physics/src/index.ts'";

/** A bundle with every kernel module, and a function that makes a world. */
async function bundleFor(condition?: string): Promise<string> {
  const conditions = ['principia-source', ...(condition === undefined ? [] : [condition])];
  const { outputFiles } = await build({
    ...bundleOptions({ conditions, sourcemap: false }),
    stdin: { contents: `export * from ${physics};`, resolveDir: '.', loader: 'ts' },
    write: false,
  });
  return outputFiles[0].text;
}

/** The texts of kernel modules that a bundle carries; each starts with the first bytes of any WebAssembly module. */
const textsIn = (bundle: string) => new Set(bundle.match(/0061736d01000000[0-9a-f]+/g));

const load = (bundle: string) => import(`data:text/javascript;base64,${Buffer.from(bundle).toString('base64')}`);

test('a bundle carries the kernels of both precisions, and under a condition those of one', async () => {
  const both = textsIn(await bundleFor());
  const [f32, f64] = [textsIn(await bundleFor('principia-f32')), textsIn(await bundleFor('principia-f64'))];
  expect(both).toEqual(new Set([...f32, ...f64]));
  // One module for each feature; elementary functions and the rotation of tensors have one build for both.
  expect(f32.size).toBe(f64.size);
  expect(both.size).toBe(f32.size + f64.size - 2);
}, 60_000);

test.each([
  ['principia-f32', 'f32', 'f64'],
  ['principia-f64', 'f64', 'f32'],
])(
  'under %s worlds are %s, and the other precision is refused by an error that says why',
  async (condition, kept, missing) => {
    const { createPhysicsWorld, step, log } = await load(await bundleFor(condition));
    const world = createPhysicsWorld({ precision: kept });
    step(world, 0.1);
    expect(world.time).toBe(0.1);
    expect(log(1)).toBe(0);
    expect(() => createPhysicsWorld({ precision: missing })).toThrow(`without the condition ${condition}`);
  },
  60_000,
);
