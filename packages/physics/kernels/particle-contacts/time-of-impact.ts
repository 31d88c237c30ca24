// When two round things that move under constant acceleration came to touch, looking back from the end of the step.
//
// With d, v and a the relative position, velocity and acceleration at the end, the distance a time t earlier is
// |d - v t + a t^2 / 2|. Without acceleration the entry is the larger root of a quadratic; with it, three Newton steps
// from that root find it to rounding.

// Unit normal from the first thing to the second at the touch, and the speed at which they met along it.
export let touchX: real = 0;
export let touchY: real = 0;
export let touchZ: real = 0;
export let touchSpeed: real = 0;

// Time since the centres came to the distance `reach`, or -1 when that was not within the last `dt`.
export function touchTime(
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
  // The second form keeps its digits where the first subtracts nearly equal numbers.
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
  if (!(time >= 0 && time <= dt)) return -1;
  const half = <real>0.5 * time;
  const px = dx - time * (vx - half * ax);
  const py = dy - time * (vy - half * ay);
  const pz = dz - time * (vz - half * az);
  const length = sqrt<real>(px * px + py * py + pz * pz);
  if (!(length > 0)) return -1;
  touchX = px / length;
  touchY = py / length;
  touchZ = pz / length;
  touchSpeed = -((vx - ax * time) * touchX + (vy - ay * time) * touchY + (vz - az * time) * touchZ);
  return time;
}
