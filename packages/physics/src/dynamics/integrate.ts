// Advances the bodies with the world's integrator, fused with all laws into one loop where possible.

import type { LocalSystem } from '../world/types.ts';
import { advanceScheme } from './advance-scheme.ts';
import { evaluateForces } from './evaluate-forces.ts';
import { runStepLoop } from './fused-step.ts';
import { startRotation } from './integrate-rotation.ts';
import { beginStep } from './validate-state.ts';

export const integrate: LocalSystem = {
  name: 'integrate',
  role: 'integrate',
  run(world, ranges, dt) {
    const { integrator, internal } = world;
    startRotation(world, ranges, dt);
    if (internal.plan?.isOneLoop === true) runStepLoop(world, ranges, dt);
    else if (integrator.advance === undefined) advanceScheme(world, ranges, dt);
    else {
      // It continues from the saved state, which systems of the user may have changed since.
      if (internal.plan?.isStartCurrent !== true) beginStep.run(world, ranges, dt);
      integrator.advance(world, ranges, dt, evaluateForces);
    }
  },
};
