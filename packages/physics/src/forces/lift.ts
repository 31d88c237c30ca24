// Lift of a wing: perpendicular to the flow and proportional to the square of its speed.
//
//   F = k |w| (s × w)        in 2D:  F = k |w| (-w_y, w_x), the flow rotated by 90° anticlockwise
//
//   k = ½ ρ C_L A, kg/m: the column Lift    w  velocity relative to the medium, m/s    s  unit vector along the span, from
//   the left wing tip to the right: a body that flies along +x with s = +z is lifted along +y.
//
// Kutta (1902), Joukowski (1906); the coefficient is constant, so the angle of attack must be small and steady, or
// the game changes `Lift.coefficient`. Lift does no work, but rigid bodies and Euler's schemes make what it turns by Ω = k |w|/m
// faster as e^(Ω² h t/2), with steps or sub-steps of h: a glider of 3 m/s without drag gains 75 % of its energy in a minute of rigid
// bodies at 60 Hz. Anderson, Fundamentals of Aerodynamics, section 1.5. Cost:
// one square root and a cross product per body; in the body's axes in 3D two cross products more.
import { Lift } from '../components/lift.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { checkKeys, checkVector, type Vector, type VectorInput } from '../errors/validate.ts';
import { suppliedVector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { checkFrame } from './support/frame.ts';
import { unit } from './support/unit-vector.ts';
import { type Wind, windParameter } from './support/wind.ts';

/** Options of `lift`. */
export interface LiftOptions {
  /** Span axis s; default +z. In 2D it is +z. */
  readonly span?: VectorInput;
  /** Whether s is in axes of the world (default) or of the body, rotating with its Orientation. */
  readonly frame?: 'world' | 'body';
  /** Velocity of the medium, m/s; default at rest. */
  readonly wind?: Wind;
}

/**
 * Lift of wings, across the flow and as the square of its speed: F = k |w| (s × w), N, with the coefficient k of
 * `lift`, kg/m, and the velocity w through the medium. For a wing that stalls see `wing`.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function lift(options: LiftOptions = {}): Force {
  checkKeys(options, 'lift', ['span', 'frame', 'wind']);
  const span = unit(checkVector(options.span ?? { z: 1 }, 'lift.span', { min: -1e12, max: 1e12 }), 'lift.span');
  const frame = checkFrame(options.frame ?? 'world', 'lift.frame');
  return liftAlong(span, frame)({ wind: options.wind ?? {} });
}

const OUT_OF_PLANE: Vector = { x: 0, y: 0, z: 1 };

function liftAlong(given: Vector, frame: 'world' | 'body') {
  return defineLaw({
    name: 'lift',
    formula: 'F = k |w| (s × w)',
    source: 'Anderson, Fundamentals of Aerodynamics, section 1.5.',
    reads: { k: Lift },
    parameters: {
      wind: windParameter,
      span: suppliedVector(({ dimensions }) => (dimensions === 3 ? given : OUT_OF_PLANE), 'axial'),
    },
    force({ velocity, k, rotate }, { span, wind }) {
      const w = velocity.sub(wind);
      const s = frame === 'body' ? rotate(span) : span;
      return s.cross(w).mul(k.mul(w.length()));
    },
  });
}
