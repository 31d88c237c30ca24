// How an encoded snapshot writes what is outside the memory: objects as a list, in which values refer to others.
import type { Shape } from '../collision/shapes/2d/shape.ts';
import { PHASES, type Phase } from '../world/phases.ts';
import type { PhysicsWorld, System } from '../world/types.ts';
import type { Contents } from './contents.ts';
import type { ArrayPlace } from './packed-bytes.ts';

/**
 * A value. Numbers that JSON has, texts, truth values and null are as they are. Others say what they are: undefined, a hole of
 * an array, a number that JSON does not have, an object of the list, a view of the world's memory, what belongs to the world (itself, its integrator,
 * a force, a system), a shape, an immutable value, or what the other world has in the same place.
 */
export type EncodedValue =
  | number
  | string
  | boolean
  | null
  | readonly ['undefined']
  | readonly ['hole']
  | readonly ['number' | 'bigint', string]
  | readonly ['object', number]
  | readonly ['memory', ArrayPlace]
  | readonly ['world', string]
  | readonly ['shape', Shape]
  | readonly ['immutable', EncodedObject]
  | readonly ['same'];

/** An object. */
export interface EncodedObject {
  readonly kind: Contents['kind'];
  readonly values: readonly EncodedValue[];
  readonly names?: readonly string[];
  /** Of a typed array, a buffer or a view of one. */
  readonly numbers?: ArrayPlace;
  /** Whether it has no prototype, or that of a class. */
  readonly prototype?: 'none' | 'class';
  /** Whether it is frozen, with all that it contains. */
  readonly isFrozen?: true;
}

/** What the lists of a world contained when a snapshot was taken, or contain now. */
export interface WorldLists {
  readonly integrator: PhysicsWorld['integrator'];
  readonly forces: PhysicsWorld['forces'];
  readonly phases: { readonly [P in Phase]: readonly System[] };
}

/** What belongs to a world, by the names that it has there. */
export function partsOfWorld(world: PhysicsWorld, { integrator, forces, phases }: WorldLists): Map<string, unknown> {
  const parts = new Map<string, unknown>([
    ['world', world],
    ['integrator', integrator],
  ]);
  forces.forEach((force, i) => {
    parts.set(`forces ${i}`, force);
  });
  for (const phase of PHASES) {
    phases[phase].forEach((system, i) => {
      parts.set(`${phase} ${i}`, system);
    });
  }
  return parts;
}

const BUILT_IN = [Array, ArrayBuffer, Map, Set, Date];

/** The prototype that an object needs, if it is neither plain nor built in, such as an array or a map. */
export function prototypeOf(value: object): EncodedObject['prototype'] {
  if (ArrayBuffer.isView(value) || BUILT_IN.some((each) => value instanceof each)) return undefined;
  const prototype = Object.getPrototypeOf(value);
  if (prototype === Object.prototype) return undefined;
  return prototype === null ? 'none' : 'class';
}
