// A loop over bodies as arithmetic: what it stores, and the checks before it stores.
import type { LaneTypes } from './function-builder.ts';
import type { Node } from './node.ts';

/** A column and the value to store there for every body. */
export interface Store {
  readonly address: number;
  readonly node: Node;
}

/** If both conditions hold for all bodies of a vector, it is not listed, and `stores` replaces its results. */
export interface RestTest {
  readonly atRest: Node;
  /** It is asked for second, because it takes columns that only bodies at rest need. */
  readonly canRest: Node;
  readonly stores: readonly Store[];
}

/** Wall test: vectors of bodies that are not inside are appended to a list. */
export interface WallTest {
  readonly inside: Node;
  /** Velocities at the start of the step, which the list keeps unless the loop stores those of all bodies. */
  readonly startVelocity: readonly Node[];
  /** Address of the list, a `WallList` of kernels/particle-contacts/walls/box.ts. */
  readonly list: number;
  readonly resting?: RestTest | undefined;
}

/** A loop as arithmetic. */
export interface LoopSource {
  readonly name: string;
  readonly types: LaneTypes;
  readonly stores: readonly Store[];
  /** Vectors per iteration: one, if omitted. Two of them hide the latency of a long chain of operations. */
  readonly vectors?: 1 | 2 | undefined;
  /** If this is false for a body, the loop stops before it stores anything in that iteration. */
  readonly inRange?: Node | undefined;
  readonly walls?: WallTest | undefined;
  /** A cheap sufficient condition for the two above, true for almost all bodies. */
  readonly fastCheck?: Node | undefined;
  /** A value that is summed over all bodies. */
  readonly total?: Node | undefined;
  /** Describes an address in printed code. */
  readonly noteOf: (address: number) => string | undefined;
}
