import { readFileSync } from 'node:fs';
import * as physics from '@principia/physics';
import { COMPONENT_NAMES, createPhysicsWorld, PhysicsError, spawn } from '@principia/physics';
import { expect, test } from 'vitest';
import { componentPage, OTHER_READERS } from './component-page.ts';

test('docs/components.md says what the source says; `npx vitest run test/docs/components.test.ts -u` writes it', async () => {
  await expect(componentPage()).toMatchFileSnapshot('../../docs/components.md');
});

test('every component has a meaning and something that reads it', () => {
  const page = componentPage();
  for (const name of COMPONENT_NAMES) {
    const section = page.split(`\n## ${name}\n`)[1]?.split('\n## ')[0] ?? '';
    expect(section.trim().split('\n')[0].length, name).toBeGreaterThan(10);
    expect(section, name).toMatch(/^Read by: [^\s.]+/m);
  }
});

test('whatever is named as a reader of components exists', () => {
  const index = ['render-core', 'render-pixi', 'render-three'].map((name) =>
    readFileSync(`packages/${name}/src/index.ts`, 'utf8'),
  );
  const known = [...Object.keys(physics), ...index.join(' ').split(/\W+/), 'query', 'world'];
  const named = Object.values(OTHER_READERS).flatMap((text) => [...text.matchAll(/`(\w+)/g)].map(([, name]) => name));
  for (const name of named) expect(known).toContain(name);
});

test('a number outside the bounds is refused, as the page says', () => {
  const world = createPhysicsWorld();
  expect(() => spawn(world, { position: {}, mass: -1 })).toThrow(PhysicsError);
  expect(() => spawn(world, { position: { z: 1 } })).toThrow(PhysicsError);
});
