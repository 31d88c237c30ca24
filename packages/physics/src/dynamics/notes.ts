// Names for addresses, so that a printed loop shows `Position.x` instead of 65600.

import type { PhysicsWorld } from '../world/types.ts';
import type { ParameterBlock } from './parameter-block.ts';

/** Returns a function that maps the address of a column to its name. */
export function notesOf(world: PhysicsWorld, block: ParameterBlock): (address: number) => string | undefined {
  let names: Map<number, string> | undefined;
  return (address) => {
    names ??= namesOf(world);
    return names.get(address) ?? block.noteOf(address);
  };
}

function namesOf({ addresses, previousAddresses, scratch, internal }: PhysicsWorld): Map<number, string> {
  const names = new Map([
    [internal.membersAt, 'components of the entity'],
    [internal.moreMembersAt, 'components of the entity'],
  ]);
  const add = (prefix: string, groups: object) => {
    for (const [name, fields] of Object.entries(groups)) {
      for (const [field, address] of Object.entries(fields as Readonly<Record<string, number>>)) {
        names.set(address, `${prefix}${name}.${field}`);
      }
    }
  };
  add('', addresses);
  add('previous ', previousAddresses);
  add('scratch ', scratch.at);
  return names;
}
