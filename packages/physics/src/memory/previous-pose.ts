import type { Addresses, Components } from '../components/all.ts';
import { MAX_POSITION } from '../components/position.ts';

/** The components of the pose: position and orientation. */
export const POSE = ['Position', 'Rotation', 'Orientation'] as const;

/** The pose of every body at the start of the last step, from which renderers interpolate. */
export type Previous = Pick<Components, (typeof POSE)[number]>;

export type PreviousAddresses = Pick<Addresses, (typeof POSE)[number]>;

/** Copies the pose of a body between columns, except values that are out of range. */
export function copyPose(from: Previous, to: Previous, eid: number): void {
  for (const name of POSE) {
    const source: Columns = from[name];
    const target: Columns = to[name];
    for (const field in source) {
      const value = source[field][eid];
      // The last valid pose must not be overwritten by a non-finite value.
      if (Math.abs(value) <= MAX_POSITION) target[field][eid] = value;
    }
  }
}

/** The columns of a component, by field. */
export type Columns = { readonly [field: string]: { [row: number]: number } };
