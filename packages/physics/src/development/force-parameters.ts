import type { Force, ParameterSource, PhysicsWorld } from '../world/types.ts';

/** What the parameters of a law are now. */
export function constantsOf(
  world: PhysicsWorld,
  { sources = [] }: { readonly sources?: readonly ParameterSource[] },
): number[][] {
  return sources.map((source) => {
    const values = new Float64Array(3);
    source.write(world, values, 0, world.time);
    return [...values];
  });
}

/** What the parameter of this name of a law is now; undefined if it has none. */
export function parameterOf(world: PhysicsWorld, force: Force, name: string): readonly number[] | undefined {
  const place = force.law?.names.indexOf(name) ?? -1;
  return place < 0 ? undefined : constantsOf(world, { sources: force.sources?.slice(place, place + 1) ?? [] })[0];
}
