// Says what a step of a world is made of.

import type { CompiledLoop } from '../laws/compile';
import { formulasOf } from '../laws/formula';
import { printModule } from '../laws/text';
import { currentPlan } from '../schedule/plan';
import { assertIdle } from '../store/guards';
import type { PhysicsWorld } from '../world';
import { schemeLoops } from './advance-scheme';
import { lawLoopOf } from './evaluate-forces';
import { stepLoop } from './fused-step';

/**
 * What a step of the world computes: the formulas of its laws, and the loops they were compiled to, in the text format
 * of WebAssembly with the names of columns. For reading, not for programs: the text may change from release to release.
 * @throws PhysicsError E_DESTROYED; E_REENTRANT inside a step; what the next step would throw
 */
export function explain(world: PhysicsWorld): string {
  assertIdle(world, 'explain');
  const { fusion } = currentPlan(world);
  const { forces, integrator, dimensions, precision } = world;
  const loops = compiledLoops(world, fusion !== undefined);
  const lines = [
    `A step in ${dimensions}D, ${precision}, by ${integrator.name}.`,
    ...forces.flatMap(({ name, law }) =>
      law === undefined
        ? [`  ${name}: a function, called for each evaluation`]
        : formulasOf(law).map((f) => `  ${name}: ${f}`),
    ),
    ...(fusion === undefined ? ['Forces and integrator are loops of their own:'] : ['All of it is one loop:']),
    ...loops.map(({ source }) => printModule(source)),
  ];
  return lines.join('\n');
}

function compiledLoops(world: PhysicsWorld, isFused: boolean): readonly CompiledLoop[] {
  if (isFused) return [stepLoop(world).compiled];
  const laws = lawLoopOf(world);
  const { scheme, advance } = world.integrator;
  const pieces = scheme === undefined || advance !== undefined ? [] : schemeLoops(world).compiled;
  return [...(laws === undefined ? [] : [laws.compiled]), ...pieces];
}
