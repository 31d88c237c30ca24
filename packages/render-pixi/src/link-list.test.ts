import { createPhysicsWorld, despawn, restore, snapshot, spawn } from '@principia/physics';
import { worldSource } from '@principia/render-core';
import { expect, it } from 'vitest';
import { LinkList, NO_LINK } from './link-list.ts';

/** Four bodies in a row, a link between each and the next, and what is shown of the links. */
function chainOfLinks() {
  const world = createPhysicsWorld({ capacity: 10 });
  const ids = [0, 1, 2, 3].map((x) => spawn(world, { position: { x }, velocity: {} }));
  const links = new LinkList(worldSource(world));
  const pairs = [1, 2, 3].flatMap((i) => [ids[i - 1], ids[i]]);
  links.set(pairs, 3);
  return { world, ids, links, pairs, shown: () => [...links.shown.subarray(0, 2 * links.count)] };
}

const NONE = [NO_LINK, NO_LINK];

it('shows no link that has lost a body, also where another body has its id, until a snapshot brings it back', () => {
  const { world, ids, links, pairs, shown } = chainOfLinks();
  expect(shown()).toEqual(pairs);
  expect(links.refresh()).toBe(false);
  const before = snapshot(world);
  despawn(world, ids[3]);
  expect(links.refresh()).toBe(true);
  expect(shown()).toEqual([...pairs.slice(0, 4), ...NONE]);
  expect(spawn(world, { position: { x: 9 } })).toBe(ids[3]);
  links.refresh();
  expect(shown()).toEqual([...pairs.slice(0, 4), ...NONE]);
  restore(world, before);
  links.refresh();
  expect(shown()).toEqual(pairs);
});

it('shows no link of a body that was exchanged between two pictures', () => {
  const { world, ids, links, pairs, shown } = chainOfLinks();
  despawn(world, ids[0]);
  expect(spawn(world, { position: { x: 9 } })).toBe(ids[0]);
  links.refresh();
  expect(shown()).toEqual([...NONE, ...pairs.slice(2)]);
  links.set(pairs, 3);
  expect(shown()).toEqual(pairs);
});

it('shows a link that is set before its bodies come as soon as they are there', () => {
  const { world, ids, links, shown } = chainOfLinks();
  links.set([ids[0], ids[3] + 1], 1);
  expect(shown()).toEqual(NONE);
  const next = spawn(world, { position: {} });
  links.refresh();
  expect(shown()).toEqual([ids[0], next]);
});

it('refuses what is no id, and then stays as it is', () => {
  const { links, pairs, shown } = chainOfLinks();
  for (const wrong of [Number.NaN, -1, 0.5, 1024]) {
    expect(() => links.set([1, 2, 3, wrong], 2)).toThrow(
      `pairs[3] must be the id of a body, from 1 to 1023, got ${wrong}`,
    );
  }
  expect(() => links.set(pairs, -1)).toThrow('got -1');
  expect(shown()).toEqual(pairs);
});
