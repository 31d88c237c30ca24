// Advances the bodies with the world's integrator, fused with all laws into one loop where possible.

import type { LocalSystem } from '../world/types.ts';
import { advanceScheme } from './advance-scheme.ts';
import { evaluateForces } from './evaluate-forces.ts';
import { runStepLoop } from './fused-step.ts';
import { startRotation } from './integrate-rotation.ts';

export const integrate: LocalSystem = {
  name: 'integrate',
  role: 'integrate',
  run(world, ranges, dt) {
    const { integrator, internal } = world;
    startRotation(world, ranges, dt);
    if (internal.plan?.fusion !== undefined) runStepLoop(world, ranges, dt);
    else if (integrator.advance !== undefined) integrator.advance(world, ranges, dt, evaluateForces);
    else advanceScheme(world, ranges, dt);
  },
};
