// Says what a step of a world is made of.

import { assertIdle } from '../ecs/guards.ts';
import type { CompiledLoop } from '../laws/compile.ts';
import { formulasOf } from '../laws/formula.ts';
import { printModule } from '../laws/text.ts';
import { currentPlan } from '../world/execution-plan.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { schemeLoops } from './advance-scheme.ts';
import { lawLoopOf } from './evaluate-forces.ts';
import { stepLoop } from './fused-step.ts';

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
