import type { PhysicsWorld } from '@principia/physics';
import type { BodySource } from './body-source.ts';

/**
 * The source that a function of a renderer was given.
 * @throws Error where there is none, or a world in its place
 */
export function sourceOf(options: { readonly source: BodySource } | undefined, caller: string): BodySource {
  const source: Partial<BodySource> | undefined = options?.source;
  if (source?.position !== undefined && source.versions !== undefined) return source as BodySource;
  throw new Error(`${caller} needs a source of bodies: ${caller}({ source: worldSource(world) })`);
}

/** @throws Error where a function of a renderer was given no world */
export function worldOf(options: { readonly world: PhysicsWorld } | undefined, caller: string): PhysicsWorld {
  const world: Partial<PhysicsWorld> | undefined = options?.world;
  if (world?.components !== undefined) return world as PhysicsWorld;
  throw new Error(`${caller} needs a world made by createPhysicsWorld: ${caller}({ world })`);
}
