// Normal, anchors and separations of a manifold at the present poses.
//
// A point is a corner of one body on an edge of the other: in a manifold that is kept it goes with the corner as that slides, and not
// with the edge. When another corner comes to the end of an edge, the manifold is another one: what went on with the old one would rest
// beyond the end of what carries it.
import { BodyPose, poseOf } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { EDGE_OF_A, EDGE_OF_B, FIRST_OF_B, KNOWN } from './manifold';
import { CORNERS_SHIFT, ON_CHAIN, RigidContact, pointOf } from './rigid-contact';

// What slides no further than this may pass an end by as much, m: corners that lie above each other would have no room at all.
const LEAST_SLIDE: real = 0.005;

// Returns whether a manifold that is kept may be: whether nothing has slid too far. Segments of chains end in the next one, and have a
// rule of their own (update-contacts.ts).
export function moveAnchors(t: RigidTable, contact: RigidContact, isKept: bool): bool {
  const a = poseOf(t, contact.a);
  const b = poseOf(t, contact.b);
  return moveWith(contact, a, b, poseOf(t, contact.bodyA), poseOf(t, contact.bodyB), isKept);
}

// The shapes turn as their bodies do, and the normal with the edge that it is of. Of two that lie flat on each other the heavier body
// turns less by itself.
// @ts-ignore: decorator
@inline function moveWith(
  contact: RigidContact,
  a: BodyPose,
  b: BodyPose,
  bodyA: BodyPose,
  bodyB: BodyPose,
  isKept: bool,
): bool {
  const cosA = a.c * contact.ac + a.s * contact.as;
  const sinA = a.s * contact.ac - a.c * contact.as;
  const cosB = b.c * contact.bc + b.s * contact.bs;
  const sinB = b.s * contact.bc - b.c * contact.bs;
  const edge = contact.flags & (EDGE_OF_A | EDGE_OF_B);
  const turnsWithA = edge != 0 ? edge == EDGE_OF_A : bodyA.inverseMass <= bodyB.inverseMass;
  const c = turnsWithA ? cosA : cosB;
  const s = turnsWithA ? sinA : sinB;
  const nx = c * contact.foundNx - s * contact.foundNy;
  const ny = s * contact.foundNx + c * contact.foundNy;
  contact.nx = nx;
  contact.ny = ny;
  const dx = bodyB.x - bodyA.x;
  const dy = bodyB.y - bodyA.y;
  const follows = isKept && (contact.flags & ON_CHAIN) == 0;
  const corners = follows ? contact.flags >> CORNERS_SHIFT : 0;
  let most: real = 0;
  for (let i = 0; i < contact.count; i++) {
    const p = pointOf(contact, i);
    const ax = cosA * p.foundAx - sinA * p.foundAy;
    const ay = sinA * p.foundAx + cosA * p.foundAy;
    const bx = cosB * p.foundBx - sinB * p.foundBy;
    const by = sinB * p.foundBx + cosB * p.foundBy;
    const x = dx + bx - ax;
    const y = dy + by - ay;
    p.separation = p.foundSeparation + nx * x + ny * y;
    // How far b has slid along the tangent (n_y, -n_x).
    const slide = x * ny - y * nx;
    most = max<real>(most, abs<real>(slide));
    const isOfB = (corners & (FIRST_OF_B << i)) != 0;
    const byA = isOfB ? slide : <real>0;
    const byB = (corners & KNOWN) != 0 && !isOfB ? slide : <real>0;
    p.ax = ax + byA * ny;
    p.ay = ay - byA * nx;
    p.bx = bx - byB * ny;
    p.by = by + byB * nx;
  }
  return !follows || most <= max<real>(contact.room, LEAST_SLIDE);
}
