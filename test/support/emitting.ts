import { createEmitter } from '../../packages/physics/src/emitters/emitter.ts';
import type { EmitterOptions } from '../../packages/physics/src/emitters/options.ts';
import type { Emitter } from '../../packages/physics/src/emitters/types.ts';
import {
  createPhysicsWorld,
  PhysicsError,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  step,
} from '../../packages/physics/src/index.ts';

/** Short constructors of worlds with an emitter, and measurements of it. */
export function emitting(options: Partial<EmitterOptions> = {}, more: PhysicsWorldOptions = {}) {
  const world = createPhysicsWorld({ capacity: 5000, ...more });
  return { world, emitter: createEmitter(world, { capacity: 1000, ...options }) };
}

export function run(world: PhysicsWorld, seconds: number, dt = 1 / 60): void {
  const steps = Math.round(seconds / dt);
  for (let i = 0; i < steps; i++) step(world, dt);
}

/** Returns the ids of living particles; an inactive entity has no mass. */
export function living({ world, ids }: Emitter): number[] {
  return [...ids].filter((eid) => world.components.Mass.value[eid] > 0);
}

export function codeOf(act: () => unknown): string {
  try {
    act();
  } catch (error) {
    return error instanceof PhysicsError ? error.code : String(error);
  }
  return 'nothing';
}
