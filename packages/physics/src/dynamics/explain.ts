// Describes the step of a world.

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
 * Returns what a step of the world computes: the formulas of its laws, and their compiled loops in WebAssembly text
 * format with column names. The text is for people and may change between releases.
 * @throws PhysicsError E_DESTROYED; E_REENTRANT inside a step; and the errors of the next step
 */
export function explain(world: PhysicsWorld): string {
  assertIdle(world, 'explain');
  const { isOneLoop } = currentPlan(world);
  const { forces, integrator, dimensions, precision } = world;
  const loops = compiledLoops(world, isOneLoop);
  const lines = [
    `A step in ${dimensions}D, ${precision}, by ${integrator.name}.`,
    ...forces.flatMap(({ name, law }) =>
      law === undefined
        ? [`  ${name}: a function, called for each evaluation`]
        : formulasOf(law).map((f) => `  ${name}: ${f}`),
    ),
    ...(isOneLoop ? ['The whole step is one loop:'] : ['Forces and integrator are separate loops:']),
    ...loops.map(({ source }) => printModule(source)),
  ];
  return lines.join('\n');
}

function compiledLoops(world: PhysicsWorld, isOneLoop: boolean): readonly CompiledLoop[] {
  if (isOneLoop) return [stepLoop(world).compiled];
  const laws = lawLoopOf(world);
  const { scheme, advance } = world.integrator;
  const segments =
    scheme === undefined || advance !== undefined ? [] : schemeLoops(world).segments.map(({ compiled }) => compiled);
  return [...(laws === undefined ? [] : [laws.compiled]), ...segments];
}
