// Entities that have components of the user and none of the package, whose ids are higher than those of all bodies.
import {
  columnsOf,
  createPhysicsWorld,
  decodeSnapshot,
  defineComponent,
  encodeSnapshot,
  type PhysicsWorld,
  realField,
  restore,
  snapshot,
  spawn,
} from '@principia/physics';
import { addComponent, addEntity, entityExists, hasComponent, query, removeComponent, removeEntity, set } from 'bitecs';
import { describe, expect, it } from 'vitest';

const Score = defineComponent({ fields: { value: realField('', { initial: 1 }) } });

function make() {
  const world = createPhysicsWorld({ capacity: 50, components: [Score] });
  return { world, score: columnsOf(world, Score) };
}

/** A body, and behind it an entity with a score of 7, or with nothing. */
function game(hasScore: boolean) {
  const made = make();
  spawn(made.world, { position: {} });
  const entity = addEntity(made.world);
  if (hasScore) addComponent(made.world, entity, set(made.score, { value: 7 }));
  return { ...made, entity };
}

function expectScore({ world, score }: ReturnType<typeof make>, entity: number): void {
  expect(entityExists(world, entity)).toBe(true);
  expect(hasComponent(world, entity, score)).toBe(true);
  expect([...query(world, [score])]).toEqual([entity]);
  expect(score.value[entity]).toBe(7);
}

const bitsOf = ({ internal }: PhysicsWorld, entity: number) => internal.moreMembers[entity];

describe('an entity with a component of the user alone', () => {
  it('comes back with it after it was removed', () => {
    const { world, score, entity } = game(true);
    const taken = snapshot(world);
    removeEntity(world, entity);
    restore(world, taken);
    expectScore({ world, score }, entity);
  });

  it('gets it back', () => {
    const { world, score, entity } = game(true);
    const taken = snapshot(world);
    removeComponent(world, entity, score);
    restore(world, taken);
    expectScore({ world, score }, entity);
  });

  it('loses one that it got since', () => {
    const { world, score, entity } = game(false);
    const taken = snapshot(world);
    addComponent(world, entity, set(score, { value: 7 }));
    restore(world, taken);
    expect(hasComponent(world, entity, score)).toBe(false);
    expect([...query(world, [score])]).toEqual([]);
    expect([score.value[entity], bitsOf(world, entity)]).toEqual([0, 0]);
  });

  it('goes to another world', () => {
    const saved = game(true);
    const loaded = make();
    restore(loaded.world, decodeSnapshot(loaded.world, encodeSnapshot(snapshot(saved.world))));
    expectScore(loaded, saved.entity);
  });

  it('comes back in a world with more entities than rows', () => {
    const { world, score, entity } = game(true);
    while (addEntity(world) < world.rows);
    const taken = snapshot(world);
    removeEntity(world, entity);
    restore(world, taken);
    expectScore({ world, score }, entity);
  });
});
