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

/**
 * The world that a function of a renderer was given.
 * @throws Error where there is none
 */
export function worldOf(options: { readonly world: PhysicsWorld } | undefined, caller: string): PhysicsWorld {
  const world: Partial<PhysicsWorld> | undefined = options?.world;
  if (world?.components !== undefined) return world as PhysicsWorld;
  throw new Error(`${caller} needs a world made by createPhysicsWorld: ${caller}({ world })`);
}

/** Every option of a function, so that none is forgotten. */
export type OptionNames<Options> = Readonly<Record<keyof Required<Options>, true>>;

/**
 * Checks that a function of a renderer has the options that it was given.
 * @throws Error for one that it does not have
 */
export function checkOptions<Options extends object>(
  options: Options,
  names: OptionNames<Options>,
  caller: string,
): void {
  for (const name of Object.keys(options)) {
    if (Object.hasOwn(names, name)) continue;
    throw new Error(`${caller} has no option “${name}”: its options are ${Object.keys(names).join(', ')}`);
  }
}

/**
 * Checks the place of a picture between the last two steps: any finite number, though only 0 to 1 lies between them.
 * @throws Error where it is no number
 */
export function checkAlpha(alpha: number): void {
  if (Number.isFinite(alpha)) return;
  throw new Error(
    `update needs a number from 0 to 1, such as runner.alpha: update(1) draws the last step; got ${alpha}`,
  );
}
