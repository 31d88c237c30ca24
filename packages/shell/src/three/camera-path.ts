/** A flight of the camera through given places, as a smooth curve over time. */
import { CatmullRomCurve3, Vector3 } from 'three';

interface Place {
  readonly x: number;
  readonly y: number;
  readonly z?: number;
}

/** Where the camera is and at what it looks at a time, s. */
export interface CameraKey {
  readonly time: number;
  readonly eye: Place;
  readonly target: Place;
}

/** A flight; before its first key and after its last one the camera stands still. */
export interface CameraPath {
  /** Writes where the camera is and at what it looks. @param time s */
  at(time: number, eye: Vector3, target: Vector3): void;
}

/**
 * Centripetal Catmull-Rom curves through the keys: they pass through each, and make no loops between them.
 * @param keys two at least, their times increasing
 */
export function createCameraPath(keys: readonly CameraKey[]): CameraPath {
  const times = keys.map(({ time }) => time);
  if (!(times.length >= 2 && times.every((time, i) => Number.isFinite(time) && (i === 0 || time > times[i - 1])))) {
    throw new Error(
      `A camera path needs two keys or more with increasing times, but the times are ${times.join(', ')}.`,
    );
  }
  const [eyes, targets] = (['eye', 'target'] as const).map(
    (name) => new CatmullRomCurve3(keys.map(({ [name]: { x, y, z = 0 } }) => new Vector3(x, y, z))),
  );
  return {
    at(time, eye, target) {
      const part = partAt(times, time);
      eyes.getPoint(part, eye);
      targets.getPoint(part, target);
    },
  };
}

/** How far along the keys a time is, from 0 to 1, where equal parts lie between neighbours. */
function partAt(times: readonly number[], time: number): number {
  const last = times.length - 1;
  let i = 0;
  while (i < last - 1 && time >= times[i + 1]) i++;
  const within = (time - times[i]) / (times[i + 1] - times[i]);
  return Math.min(1, Math.max(0, (i + within) / last));
}
