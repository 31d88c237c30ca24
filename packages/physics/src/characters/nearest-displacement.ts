// The displacement nearest to a wanted one that keeps a character off all surfaces. In the plane it is the wanted one, or it
// ends on one line, or where two lines meet: all of these are tried.
import { dot, gapTo, plus, type Surface, type Vector2 } from './surface.ts';

/** Lengths below this are rounding errors, m. */
const ROUNDING = 1e-9;

/** Sine of the angle below which two lines do not meet. */
const PARALLEL = 1e-6;

/**
 * Returns the displacement nearest to `wanted` after which no surface is too near; if there is none, because the character is
 * squeezed, one after which the worst of them is least too near.
 * @param maxChange greatest change of the wanted displacement, m
 */
export function nearestDisplacement(
  position: Vector2,
  wanted: Vector2,
  surfaces: readonly Surface[],
  maxChange: number,
): Vector2 {
  let best = { displacement: wanted, lack: Infinity, square: Infinity };
  const consider = (displacement: Vector2) => {
    const end = plus(position, displacement);
    const lack = surfaces.reduce((worst, surface) => Math.max(worst, -gapTo(surface, end)), ROUNDING);
    const change = plus(displacement, wanted, -1);
    const square = dot(change, change);
    if (square > maxChange * maxChange) return;
    if (lack < best.lack || (lack === best.lack && square < best.square)) best = { displacement, lack, square };
  };
  consider(wanted);
  if (best.lack === ROUNDING) return wanted;
  const end = plus(position, wanted);
  surfaces.forEach((surface, i) => {
    consider(plus(wanted, surface.normal, -gapTo(surface, end)));
    for (const other of surfaces.slice(0, i)) {
      const corner = meeting(surface, other);
      if (corner !== undefined) consider(plus(corner, position, -1));
    }
  });
  return best.displacement;
}

/** The position at which two lines meet, undefined if they are parallel. */
function meeting(a: Surface, b: Surface): Vector2 | undefined {
  const cross = a.normal.x * b.normal.y - a.normal.y * b.normal.x;
  if (Math.abs(cross) < PARALLEL) return undefined;
  return {
    x: (a.offset * b.normal.y - b.offset * a.normal.y) / cross,
    y: (b.offset * a.normal.x - a.offset * b.normal.x) / cross,
  };
}
