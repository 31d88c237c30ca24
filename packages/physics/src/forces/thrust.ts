// A steady force on each body, from a column of its own: jets, oars, a rudder.
//
//   F = T        or, with T in the body's axes,  F = R T
//
//   T  the column Thrust, N: write it to steer    R  rotation of the body, from Rotation or Orientation
//
// No mass is consumed; see `rocketEngines`. Cost: one addition per axis; in the body's axes a sine and a cosine in
// 2D, two cross products in 3D.
import { Thrust } from '../components/propulsion.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { checkKeys } from '../errors/validate.ts';
import type { Force } from '../world/types.ts';
import { checkFrame } from './support/frame.ts';

export interface ThrustOptions {
  /** Whether the vector is in axes of the world (default) or of the body. */
  readonly frame?: 'world' | 'body';
}

/** @throws PhysicsError E_TYPE, E_RANGE, E_UNKNOWN */
export function thrust(options: ThrustOptions = {}): Force {
  checkKeys(options, 'thrust', ['frame']);
  return checkFrame(options.frame ?? 'world', 'thrust.frame') === 'world' ? inWorld() : inBody();
}

const inWorld = /* @__PURE__ */ defineLaw({
  name: 'thrust',
  formula: 'F = T',
  reads: { push: Thrust },
  force: ({ push }) => push,
});

const inBody = /* @__PURE__ */ defineLaw({
  name: 'thrust',
  formula: 'F = R T',
  reads: { push: Thrust },
  force: ({ push, rotate }) => rotate(push),
});
