import { expect, test } from 'vitest';
import { despawn, spawn } from '../bodies/spawn.ts';
import { springs } from '../forces/springs.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { createCloth } from '../soft-bodies/cloth.ts';
import { createRope } from '../soft-bodies/rope.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { xpbd } from './xpbd.ts';

/** Builds two networks with other bodies between them, so that spring ids are not all consecutive. */
function build(precision: 'f32' | 'f64') {
  const forces = [uniformGravity(), springs()];
  const integrator = xpbd({ substeps: 2, iterations: 2 });
  const world = createPhysicsWorld({ dimensions: 3, capacity: 1000, precision, integrator, forces });
  const size = { columns: 9, rows: 7, spacing: 0.1, mass: 1, shear: 50, bend: 5, structural: 900, damping: 0.01 };
  const sheet = createCloth(world, { ...size, corner: {} });
  const rope = createRope(world, { from: { y: 1 }, to: { x: 1, y: 1 }, nodes: 12, mass: 1, stiffness: 400 });
  return { world, all: [...sheet.springs, ...rope.springs], nodes: [...sheet.nodes, ...rope.nodes] };
}

type Built = ReturnType<typeof build>;

const CHANGES: Readonly<Record<string, (built: Built) => void>> = {
  'no change': () => {},
  'the stiffness of one': ({ world, all }) => {
    world.components.Spring.stiffness[all[all.length - 1]] *= 2;
  },
  'the stiffness of all': ({ world, all }) => {
    for (const id of all) world.components.Spring.stiffness[id] *= 2;
  },
  'a length': ({ world, all }) => {
    world.components.Spring.length[all[40]] *= 1.0001;
  },
  'two lengths, one for the other': ({ world, all }) => {
    const { length } = world.components.Spring;
    const [a, b] = [all[0], all[all.length - 1]];
    [length[a], length[b]] = [length[b], length[a]];
  },
  damping: ({ world, all }) => {
    world.components.Spring.damping[all[7]] = 1;
  },
  tensionOnly: ({ world, all }) => {
    for (const id of all) world.components.Spring.tensionOnly[id] = 1;
  },
  'a mass': ({ world, nodes }) => {
    world.components.Mass.value[nodes[30]] *= 3;
  },
};

test.each(Object.keys(CHANGES).flatMap((change) => (['f32', 'f64'] as const).map((real) => [change, real] as const)))(
  'a change in place takes effect in the next step: %s, in %s',
  (change, precision) => {
    const run = (name: string, rebuild: boolean) => {
      const built = build(precision);
      const { world, nodes } = built;
      for (let s = 0; s < 3; s++) step(world, 1 / 60);
      CHANGES[name](built);
      // Adding and removing a body makes the solver read all springs again.
      if (rebuild) despawn(world, spawn(world, { position: {} }));
      for (let s = 0; s < 2; s++) step(world, 1 / 60);
      const { x, y } = world.components.Position;
      return nodes.flatMap((node) => [x[node], y[node]]);
    };
    const places = run(change, false);
    expect(places).toEqual(run(change, true));
    if (change !== 'no change') expect(places).not.toEqual(run('no change', false));
  },
);
