// Layout of the columns of a world: worlds of equal layout share compiled code.
import { componentNumber } from '../laws/structure.ts';
import type { PhysicsWorld } from '../world/types.ts';
import type { ParameterBlock } from './parameter-block.ts';

/** Returns everything that the addresses in a loop depend on. */
export function layoutOf(
  { dimensions, precision, rows, addresses, internal }: PhysicsWorld,
  block: ParameterBlock,
): unknown[] {
  const own = [...internal.ownComponents].map(([component, columns]) => [
    componentNumber(component),
    columns.addresses,
  ]);
  const { counts, partialEntities } = internal;
  const members = [partialEntities.immovable > 0, counts.GravityScale > 0];
  return [dimensions, precision, rows, addresses.Position.x, block.at, members, own];
}
