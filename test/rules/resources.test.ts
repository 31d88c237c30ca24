/** State of a world is found in another by its name: every resource of the package that snapshots hold has one of its own. */
import { expect, it } from 'vitest';
import { isTest, read, typescriptFiles } from './sources.ts';

const sources = typescriptFiles
  .filter((file) => file.startsWith('packages/physics/src/') && !isTest(file) && !file.endsWith('memory/resource.ts'))
  .map((file) => [file, read(file)] as const);

it('every resource has a name, unless snapshots leave it out', () => {
  const unnamed = sources.filter(
    ([, text]) =>
      /= (\/\* @__PURE__ \*\/ )?resource(<\w+>)?\(/.test(text) && !text.includes('excludeFromSnapshot: true'),
  );
  expect(unnamed.map(([file]) => file)).toEqual([]);
});

it('no two resources have the same name', () => {
  const names = sources.flatMap(([, text]) =>
    [...text.matchAll(/namedResource(?:<\w+>)?\(\s*'([^']+)'/g)].map((m) => m[1]),
  );
  // The pattern finds them.
  expect(names.length).toBeGreaterThan(30);
  expect(names.filter((name, i) => names.indexOf(name) !== i)).toEqual([]);
});
