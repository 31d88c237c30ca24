import type { PhysicsWorld } from '../world/types.ts';
import { warnOnce } from './warn-once.ts';

/** A promise rejects after the step, which cannot throw then; an unhandled rejection would end the process. */
export function reportRejection(world: PhysicsWorld, what: string, result: Promise<unknown>): void {
  result.catch((error) => {
    warnOnce(world, {
      message: `an asynchronous ${what} was rejected: ${error}`,
      hint: 'Handlers and systems are synchronous: what follows an `await` runs after the step. Catch its errors there.',
    });
  });
}
