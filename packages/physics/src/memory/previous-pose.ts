import type { Addresses, Components } from '../components/all.ts';

/** The components of the pose: position and orientation. */
export const POSE = ['Position', 'Rotation', 'Orientation'] as const;

/** The pose of every body at the start of the last step, from which renderers interpolate. */
export type Previous = Pick<Components, (typeof POSE)[number]>;

export type PreviousAddresses = Pick<Addresses, (typeof POSE)[number]>;

/** Copies the pose of a body between columns. */
export function copyPose(from: Previous, to: Previous, eid: number): void {
  for (const name of POSE) {
    const source: Columns = from[name];
    const target: Columns = to[name];
    for (const field in source) target[field][eid] = source[field][eid];
  }
}

/** The columns of a component, by field. */
export type Columns = { readonly [field: string]: { [row: number]: number } };
