import { expect, test } from 'vitest';
import * as joints from '../../packages/physics/src/index.ts';
import { JOINT_FILES, jointPage } from './joint-page.ts';

test('docs/joints.md says what the source says; `npx vitest run test/docs/joints.test.ts -u` writes it', async () => {
  await expect(jointPage()).toMatchFileSnapshot('../../docs/joints.md');
});

test('every joint is on the page, and each of its options says what it is', () => {
  const page = jointPage();
  for (const maker of Object.keys(JOINT_FILES)) expect(joints, maker).toHaveProperty(maker);
  for (const row of page.split('\n').filter((line) => line.startsWith('| `'))) expect(row).not.toMatch(/\| +\|$/);
});
