// Warnings about joints that are made where they cannot stay.
import { JOINT_KINDS } from '../components/joint.ts';
import { warnOnce } from '../errors/warn-once.ts';
import { cos, sin } from '../math/elementary.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** A joint may begin this far beyond its limits, m or rad: bodies are often placed by eye. */
const LIMIT_TOLERANCE = 0.05;

/** Warns if a new joint begins beyond its limits: the solver pulls it there at once, and the bodies keep the speed. */
export function warnAboutLimits(world: PhysicsWorld, joint: Readonly<Record<string, number>>): void {
  const kind = JOINT_KINDS[joint.kind];
  const isDistance = kind === 'distance';
  const now = isDistance ? anchorDistance(world, joint) : 0;
  if (isDistance && joint.hasLimits !== 1 && !(joint.hertz > 0)) warnAboutLength(world, now, joint.length);
  if (joint.hasLimits !== 1) return;
  const isBelow = now < joint.lower - LIMIT_TOLERANCE;
  if (!isBelow && now <= joint.upper + LIMIT_TOLERANCE) return;
  const limit = isBelow ? `less than its lower limit, ${joint.lower}` : `more than its upper limit, ${joint.upper}`;
  const place = isDistance ? `anchors are ${Number(now.toPrecision(3))} m apart` : 'coordinate is 0';
  const warning = {
    message: `a ${kind} joint was made beyond its limits: its ${place}, ${limit}. It is pulled there at once.`,
    hint: isDistance
      ? 'Put the bodies where the limits hold before you join them.'
      : 'The coordinate of a joint is 0 as its bodies are when it is made: let the limits include 0.',
  };
  warnOnce(world, warning, `limits of a ${kind} joint`);
}

function warnAboutLength(world: PhysicsWorld, now: number, length: number): void {
  if (Math.abs(now - length) <= LIMIT_TOLERANCE) return;
  const warning = {
    message: `a rod of ${length} m was made between anchors that are ${Number(now.toPrecision(3))} m apart. It is brought to its length at once.`,
    hint: 'Put the bodies at that distance before you join them, or leave `length` out.',
  };
  warnOnce(world, warning, 'length of a rod');
}

/** The distance of the anchors of a joint that is about to be made, m. */
function anchorDistance({ components }: PhysicsWorld, joint: Readonly<Record<string, number>>): number {
  const place = (body: number, x: number, y: number) => {
    if (body === 0) return [x, y];
    const angle = components.Rotation.angle[body];
    const [c, s] = [cos(angle), sin(angle)];
    return [components.Position.x[body] + c * x - s * y, components.Position.y[body] + s * x + c * y];
  };
  const [ax, ay] = place(joint.a ?? 0, joint.ax, joint.ay);
  const [bx, by] = place(joint.b, joint.bx, joint.by);
  return Math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
}
