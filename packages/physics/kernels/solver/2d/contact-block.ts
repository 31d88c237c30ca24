// A block of contacts that are solved side by side: one vector for each of these numbers, with a lane for each contact.
import { RigidTable } from './rigid-table';

// @ts-ignore: decorator
@inline const V: usize = 16;

// Addresses of the states of the bodies a and b, and the number of the contact's record.
export const A: usize = 0;
export const B: usize = V;
export const SLOT: usize = 2 * V;
// Inverse masses, 0 along a locked axis, and moments of inertia.
export const MASS_AX: usize = 3 * V;
export const MASS_AY: usize = 4 * V;
export const INERTIA_A: usize = 5 * V;
export const MASS_BX: usize = 6 * V;
export const MASS_BY: usize = 7 * V;
export const INERTIA_B: usize = 8 * V;
export const NX: usize = 9 * V;
export const NY: usize = 10 * V;
export const FRICTION: usize = 11 * V;
export const TANGENT_SPEED: usize = 12 * V;
export const ROLLING: usize = 13 * V;
export const ROLLING_MASS: usize = 14 * V;
export const ROLLING_IMPULSE: usize = 15 * V;
// Softness: the rate at which overlap is pushed out, 1/s, times the mass scale; mass scale and impulse scale.
export const BIAS_RATE: usize = 16 * V;
export const MASS_SCALE: usize = 17 * V;
export const IMPULSE_SCALE: usize = 18 * V;
export const RESTITUTION: usize = 19 * V;
// An impulse P makes no angular momentum if its levers at a and at b differ by (x_b - x_a) × P. So they follow when b has moved by d
// from a since the step began: that of a is longer by its share of d × P, that of b shorter by its own. The shares are 1
// together; the lighter body has the smaller one, and turns nearly as it would alone. Both are 0 for an impact that is foreseen, whose
// levers are those of its moment, and for what bounces, whose impulses are found anew when the step ends (impacts/2d).
export const SHARE_A: usize = 20 * V;
export const SHARE_B: usize = 21 * V;
// Two points follow, each with these. A rounded shape touches with another point of its surface as it turns, and so its
// anchor is the point that the rounding is round: the centre of a disc.
export const POINTS: usize = 22 * V;
export const AX: usize = 0;
export const AY: usize = V;
export const BX: usize = 2 * V;
export const BY: usize = 3 * V;
// Separation less n · (anchor of b - anchor of a).
export const SEPARATION: usize = 4 * V;
// Effective masses along the normal and the tangent, kg.
export const NORMAL_MASS: usize = 5 * V;
export const TANGENT_MASS: usize = 6 * V;
export const NORMAL_IMPULSE: usize = 7 * V;
export const TANGENT_IMPULSE: usize = 8 * V;
export const TOTAL_IMPULSE: usize = 9 * V;
export const TOTAL_TANGENT_IMPULSE: usize = 10 * V;
export const NORMAL_SPEED: usize = 11 * V;
// Levers of impulses along the normal n and the tangent (n_y, -n_x) about the centres of both bodies, r × n and r × t, where the
// surfaces meet.
export const NORMAL_LEVER_A: usize = 12 * V;
export const NORMAL_LEVER_B: usize = 13 * V;
export const TANGENT_LEVER_A: usize = 14 * V;
export const TANGENT_LEVER_B: usize = 15 * V;
export const POINT: usize = 16 * V;
export const CONTACT_BLOCK: usize = POINTS + 2 * POINT;

// Until the block is finished (finish-blocks.ts), these are where the levers of the second point are later. Radii by which the shapes
// are rounded: the surface is so far from the anchor, along the normal. And from the centre of a to that of b, m.
export const ROUNDING_A: usize = POINTS + POINT + NORMAL_LEVER_A;
export const ROUNDING_B: usize = POINTS + POINT + NORMAL_LEVER_B;
export const APART_X: usize = POINTS + POINT + TANGENT_LEVER_A;
export const APART_Y: usize = POINTS + POINT + TANGENT_LEVER_B;

// @ts-ignore: decorator
@inline export function blockOf(t: RigidTable, i: i32): usize {
  return t.blocks + <usize>i * CONTACT_BLOCK;
}

// A contact with two points whose second approaches faster than this when the step begins is hit, m/s.
export const HIT_SPEED: real = 0.25;

// No impulse is larger than this, N s: a number that is not finite would reach every body of a heap.
export const MAX_IMPULSE: real = 1e30;
