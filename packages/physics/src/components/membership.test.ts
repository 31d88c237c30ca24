// A world with more components than one word of membership holds: the list of components is lengthened by components
// whose bits are in the second word.
import { addComponent, hasComponent, query, removeComponent, set } from 'bitecs';
import { describe, expect, test, vi } from 'vitest';

vi.mock('./all.ts', async (importOriginal) => {
  const original = await importOriginal<typeof import('./all.ts')>();
  const { defineComponent, real } = await import('./define.ts');
  const COMPONENTS: Record<string, unknown> = { ...original.COMPONENTS };
  while (Object.keys(COMPONENTS).length < 40) {
    COMPONENTS[`Extra${Object.keys(COMPONENTS).length}`] = defineComponent({ fields: { value: real('') } });
  }
  return { ...original, COMPONENTS, COMPONENT_NAMES: Object.keys(COMPONENTS) };
});

const { createPhysicsWorld } = await import('../world/create-world.ts');
const { spawn } = await import('../bodies/spawn.ts');
const { spawnMany } = await import('../bodies/spawn-many.ts');
const { snapshot, restore } = await import('../snapshot/snapshot.ts');
const { stateHash } = await import('../diagnostics/hash.ts');
const { step } = await import('../world/step.ts');
const { defineLaw } = await import('../dynamics/define-law.ts');
const { restrictForce } = await import('../forces/restrict-force.ts');
const { uniformGravity } = await import('../forces/uniform-gravity.ts');
const { select, vec3 } = await import('../laws/expression.ts');
const { COMPONENTS, COMPONENT_NAMES } = await import('./all.ts');
const { bitOf, FIRST_WORD } = await import('./membership.ts');

const EXTRA = COMPONENT_NAMES[FIRST_WORD + 3];

function extraOf(world: ReturnType<typeof createPhysicsWorld>) {
  return world.components[EXTRA] as unknown as { value: Float64Array };
}

describe('a component whose bit is in the second word', () => {
  test('is added, read, written and removed like any other', () => {
    const world = createPhysicsWorld({ capacity: 4 });
    const extra = extraOf(world);
    const body = spawn(world, { position: {} });
    addComponent(world, body, set(extra, { value: 3 }));
    expect([hasComponent(world, body, extra), extra.value[body], world.internal.counts[EXTRA]]).toEqual([true, 3, 1]);
    expect([...query(world, [extra])]).toEqual([body]);
    removeComponent(world, body, extra);
    expect([hasComponent(world, body, extra), extra.value[body], world.internal.counts[EXTRA]]).toEqual([false, 0, 0]);
  });

  test('is given to many at once, and comes back from a snapshot', () => {
    const world = createPhysicsWorld({ capacity: 8 });
    const extra = extraOf(world);
    const key = EXTRA[0].toLowerCase() + EXTRA.slice(1);
    const ids = spawnMany(world, 3, { position: {}, [key]: { value: 2 } } as never);
    expect([...query(world, [extra])]).toEqual([...ids]);
    const [saved, hash] = [snapshot(world), stateHash(world)];
    removeComponent(world, ids[1], extra);
    expect(stateHash(world)).not.toBe(hash);
    restore(world, saved);
    expect([stateHash(world), hasComponent(world, ids[1], extra), extra.value[ids[1]]]).toEqual([hash, true, 2]);
  });

  test('is asked for by laws and restricts forces', () => {
    const law = defineLaw({
      name: 'a push for some',
      acceleration: ({ has }) => vec3(select(has(COMPONENTS[EXTRA]), 2, 0), 0, 0),
    });
    const fall = restrictForce(uniformGravity({ y: -10 }), { group: [EXTRA, 'Mass'] });
    const world = createPhysicsWorld({ capacity: 4, forces: [law(), fall] });
    const [without, withExtra] = [0, 1].map(() => spawn(world, { position: {}, velocity: {}, mass: 1 }));
    addComponent(world, withExtra, extraOf(world));
    step(world, 0.5);
    const { x, y } = world.components.Velocity;
    expect([x[without], y[without], x[withExtra], y[withExtra]]).toEqual([0, 0, 1, -5]);
  });

  test('cannot be combined by kernels, which is said at once', () => {
    expect(() => bitOf(EXTRA)).toThrow(/E_RANGE.*not in the first word/);
  });
});
