// A steady force on each body, from a column of its own: jets, oars, a rudder.
//
//   F = T        or, with T in the body's axes,  F = R T        τ = R p × F
//
//   T  the column Thrust, N: write it to steer    R  rotation of the body, from Rotation or Orientation
//   p  point of application in the body's axes, m: a jet that is not in line with the centre of mass rotates the body
//
// No mass is consumed; see `rocketEngines`. Cost: one addition per axis; in the body's axes a sine and a cosine in
// 2D, two cross products in 3D; three cross products for a point.
import { Thrust } from '../components/propulsion.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { checkKeys, checkVector, type VectorInput } from '../errors/validate.ts';
import { vector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { POSITION_BOUNDS } from './support/bounds.ts';
import { checkFrame } from './support/frame.ts';

/** Options of `thrust`. */
export interface ThrustOptions {
  /** Whether the vector is in axes of the world (default) or of the body. */
  readonly frame?: 'world' | 'body';
  /** Point of application p in the body's axes, m; default the centre of mass, without torque. */
  readonly point?: VectorInput;
}

/**
 * A steady force on each body, from the component `thrust`, N: jets, oars, a rudder. In the axes of the world or of
 * the body, where it may act at a point.
 * @throws PhysicsError E_TYPE, E_RANGE, E_UNKNOWN
 */
export function thrust(options: ThrustOptions = {}): Force {
  checkKeys(options, 'thrust', ['frame', 'point']);
  const frame = checkFrame(options.frame ?? 'world', 'thrust.frame');
  if (options.point === undefined) return frame === 'world' ? inWorld() : inBody();
  const point = checkVector(options.point, 'thrust.point', POSITION_BOUNDS);
  return frame === 'world' ? inWorldAt({ point }) : inBodyAt({ point });
}

const inWorld = /* @__PURE__ */ defineLaw({
  name: 'thrust',
  formula: 'F = T',
  reads: { T: Thrust },
  force: ({ T }) => T,
});

const inBody = /* @__PURE__ */ defineLaw({
  name: 'thrust',
  formula: 'F = R T',
  reads: { T: Thrust },
  force: ({ T, rotate }) => rotate(T),
});

const inWorldAt = /* @__PURE__ */ defineLaw({
  name: 'thrust',
  formula: 'F = T, τ = R p × F',
  reads: { T: Thrust },
  parameters: { point: vector('m', POSITION_BOUNDS) },
  force: ({ T }) => T,
  torque: ({ T, rotate }, { point }) => rotate(point).cross(T),
});

const inBodyAt = /* @__PURE__ */ defineLaw({
  name: 'thrust',
  formula: 'F = R T, τ = R p × F',
  reads: { T: Thrust },
  parameters: { point: vector('m', POSITION_BOUNDS) },
  force: ({ T, rotate }) => rotate(T),
  torque: ({ T, rotate }, { point }) => rotate(point).cross(rotate(T)),
});
