import { expect, test } from 'vitest';
import { expectNone, isTest, read, typescriptFiles } from './sources.ts';

const folder = 'packages/physics/src/ecs/bitecs/';

test('one folder touches what bitECS does not promise', () => {
  const tables = /\$internal|\bcontextOf\(|\bWorldContext\b/;
  const users = typescriptFiles
    .filter((path) => /^packages\/[^/]+\/src\//.test(path) && !isTest(path))
    .filter((path) => tables.test(read(path)));
  expect(users.some((path) => path.startsWith(folder))).toBe(true);
  const violations = users.filter((path) => !path.startsWith(folder));
  expectNone(`Only ${folder} reads and writes bitECS's own tables:`, violations);
});
