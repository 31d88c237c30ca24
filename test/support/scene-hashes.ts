import { step } from '@principia/physics';
import { SCENES } from '@principia/scenes';
import { motionHash } from './chaos.ts';

/** The hash of every scene, small, after `steps` steps: the same on every JavaScript engine. */
export function sceneHashes(steps = 240): Record<string, string> {
  return Object.fromEntries(
    SCENES.map((scene) => {
      const { world, dt, advance } = scene.create({ count: Math.min(200, scene.parameters.count.max) });
      for (let i = 0; i < steps; i++) {
        if (advance === undefined) step(world, dt);
        else advance(world);
      }
      return [scene.name, motionHash(world)];
    }),
  );
}
