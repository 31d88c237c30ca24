// Time of impact of two round bodies under constant acceleration, measured back from the end of the step.
//
// With d, v and a the relative position, velocity and acceleration at the end, the distance a time t earlier is |d - v
// t + a t^2 / 2|. Without acceleration the entry is the larger root of a quadratic; with acceleration, three Newton
// iterations from that root converge to rounding.

// Unit normal from the first body to the second at the impact, and their closing speed along it.
@unmanaged
class RoundImpact {
  nx: real;
  ny: real;
  nz: real;
  speed: real;
}

// The impact found last.
export const roundImpact = changetype<RoundImpact>(memory.data(offsetof<RoundImpact>(), 8));

// Returns the time since the centres were `reach` apart, or -1 if that was not within the last `dt`.
export function timeSinceRoundImpact(
  dx: real,
  dy: real,
  dz: real,
  vx: real,
  vy: real,
  vz: real,
  ax: real,
  ay: real,
  az: real,
  reach: real,
  dt: real,
): real {
  const along = dx * vx + dy * vy + dz * vz;
  const square = vx * vx + vy * vy + vz * vz;
  const gap = dx * dx + dy * dy + dz * dz - reach * reach;
  const discriminant = along * along - square * gap;
  if (!(discriminant >= 0) || !(square > 0)) return -1;
  const root = sqrt<real>(discriminant);
  // The second form avoids the cancellation that the first has for nearly equal terms.
  let time = along < 0 && gap < 0 ? -gap / (root - along) : (along + root) / square;
  if (ax != 0 || ay != 0 || az != 0) {
    for (let i = 0; i < 3; i++) {
      const half = <real>0.5 * time;
      const px = dx - time * (vx - half * ax);
      const py = dy - time * (vy - half * ay);
      const pz = dz - time * (vz - half * az);
      const slope = <real>2 * (px * (ax * time - vx) + py * (ay * time - vy) + pz * (az * time - vz));
      if (!(slope > 0)) break;
      time -= (px * px + py * py + pz * pz - reach * reach) / slope;
    }
  }
  // Bodies that overlap have met: where that was just now, rounding may put it behind the end of the step.
  if (time < 0 && gap <= 0) time = 0;
  if (!(time >= 0 && time <= dt)) return -1;
  const half = <real>0.5 * time;
  const px = dx - time * (vx - half * ax);
  const py = dy - time * (vy - half * ay);
  const pz = dz - time * (vz - half * az);
  const length = sqrt<real>(px * px + py * py + pz * pz);
  if (!(length > 0)) return -1;
  const nx = px / length;
  const ny = py / length;
  const nz = pz / length;
  roundImpact.nx = nx;
  roundImpact.ny = ny;
  roundImpact.nz = nz;
  roundImpact.speed = -((vx - ax * time) * nx + (vy - ay * time) * ny + (vz - az * time) * nz);
  return time;
}
