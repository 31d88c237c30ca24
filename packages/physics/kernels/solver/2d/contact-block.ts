// A block of contacts that are solved side by side: one vector for each of these numbers, with a lane for each contact. Numbers that a
// pass of the solver reads together lie together, and a block begins with a line of the cache and ends with one: solving reads blocks
// faster than memory brings them.
import { RigidTable } from './rigid-table';

// @ts-ignore: decorator
@inline const V: usize = 16;

// Addresses of the states of the bodies a and b.
export const A: usize = 0;
export const B: usize = V;
// Inverse masses, 0 along a locked axis, and moments of inertia.
export const MASS_AX: usize = 2 * V;
export const MASS_AY: usize = 3 * V;
export const MASS_BX: usize = 4 * V;
export const MASS_BY: usize = 5 * V;
export const INERTIA_A: usize = 6 * V;
export const INERTIA_B: usize = 7 * V;
export const NX: usize = 8 * V;
export const NY: usize = 9 * V;
// An impulse P makes no angular momentum if its levers at a and at b differ by (x_b - x_a) × P. So they follow when b has moved by d
// from a since the step began: that of a is longer by its share of d × P, that of b shorter by the rest. The lighter body has the
// smaller share, and turns nearly as it would alone, unless a corner is on an edge.
export const SHARE_A: usize = 10 * V;
// How far along the normal and across it levers follow, m (finish-blocks.ts). 0 for an impact that is foreseen, whose levers are those
// of its moment, and for one that may bounce, whose impulses are found anew when the step ends (impacts/2d).
export const REACH: usize = 11 * V;
export const ROLLING_IMPULSE: usize = 12 * V;
// Softness: the rate at which overlap is pushed out, 1/s, times the mass scale, and the mass scale. The impulse scale is what that
// is short of 1.
export const BIAS_RATE: usize = 13 * V;
export const MASS_SCALE: usize = 14 * V;
// The number of the contact's record.
export const SLOT: usize = 15 * V;
export const FRICTION: usize = 16 * V;
export const TANGENT_SPEED: usize = 17 * V;
export const ROLLING: usize = 18 * V;
export const ROLLING_MASS: usize = 19 * V;
// Two points follow, each with these. How far the anchors of a and of b are from the centres of their bodies along the normal when the
// step begins. A rounded shape touches with another point of its surface as it turns, and so its anchor is the point that the
// rounding is round: the centre of a disc.
export const POINTS: usize = 20 * V;
export const ALONG_A: usize = 0;
export const ALONG_B: usize = V;
// Separation less the distance between the anchors along the normal.
export const SEPARATION: usize = 2 * V;
// Effective masses along the normal and the tangent, kg.
export const NORMAL_MASS: usize = 3 * V;
export const NORMAL_IMPULSE: usize = 4 * V;
// Levers of impulses along the normal n and the tangent (n_y, -n_x) about the centres of both bodies, r × n and r × t, where the
// surfaces meet.
export const NORMAL_LEVER_A: usize = 5 * V;
export const NORMAL_LEVER_B: usize = 6 * V;
export const TANGENT_LEVER_A: usize = 7 * V;
export const TANGENT_LEVER_B: usize = 8 * V;
export const TANGENT_IMPULSE: usize = 9 * V;
export const TANGENT_MASS: usize = 10 * V;
export const TOTAL_IMPULSE: usize = 11 * V;
export const TOTAL_TANGENT_IMPULSE: usize = 12 * V;
export const NORMAL_SPEED: usize = 13 * V;
export const POINT: usize = 14 * V;
export const CONTACT_BLOCK: usize = POINTS + 2 * POINT;

// Until a block is finished (finish-blocks.ts), the anchors of each point on both surfaces, from the centres, are where its levers
// are later, and in place of the reach is what the shares are together: 1, or 0 where levers stay. In place of what is `ALONG` the
// normal are radii by which the shapes are rounded, and the distance from the centre of a to that of b, m. Then the time from the
// moment of the normal to the mean of the sub-steps, s, the restitution, and which body has the only point as its corner,
// CORNER_OF_A or CORNER_OF_B.
export const SHARES: usize = REACH;
export const AHEAD: usize = ROLLING_MASS;
export const RESTITUTION: usize = POINTS + TOTAL_IMPULSE;
export const CORNER: usize = POINTS + TOTAL_TANGENT_IMPULSE;
export const CORNER_OF_A: real = 1;
export const CORNER_OF_B: real = -1;
export const AX: usize = NORMAL_LEVER_A;
export const AY: usize = NORMAL_LEVER_B;
export const BX: usize = TANGENT_LEVER_A;
export const BY: usize = TANGENT_LEVER_B;
export const ROUNDING_A: usize = POINTS + ALONG_A;
export const ROUNDING_B: usize = POINTS + ALONG_B;
export const APART_X: usize = POINTS + POINT + ALONG_A;
export const APART_Y: usize = POINTS + POINT + ALONG_B;

// @ts-ignore: decorator
@inline export function blockOf(t: RigidTable, i: i32): usize {
  return t.blocks + <usize>i * CONTACT_BLOCK;
}

// A contact with two points whose second approaches faster than this when the step begins is hit, m/s.
export const HIT_SPEED: real = 0.25;

// No impulse is larger than this, N s: a number that is not finite would reach every body of a heap.
export const MAX_IMPULSE: real = 1e30;
