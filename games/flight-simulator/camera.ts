/** Two cameras: one that follows the aeroplane, and the eyes of the pilot. */
import { Euler, type PerspectiveCamera, Quaternion, Vector3 } from 'three';
import { groundHeight } from './terrain.ts';

/** Where the following camera is, seen from the aeroplane: m behind and above. */
const BEHIND = 17;
const ABOVE = 4.2;
const EYE = new Vector3(0.5, 0.5, -0.12);
/** Time in which the following camera turns with the aeroplane, s. */
const LAG = 0.45;

export interface FlightCamera {
  /** The player's own angles, rad, and factor of distance. */
  readonly own: { turn: number; lift: number; distance: number };
  /** Jumps to its place: after a restart. */
  reset(): void;
  update(position: Vector3, attitude: Quaternion, isCockpit: boolean, seconds: number): void;
}

export function createFlightCamera(camera: PerspectiveCamera): FlightCamera {
  const own = { turn: 0, lift: 0, distance: 1 };
  const direction = new Vector3(1, 0, 0);
  const target = new Vector3();
  const side = new Vector3();
  const wanted = new Vector3();
  const turn = new Quaternion();
  /** Cameras look along -z, the aeroplane along +x. */
  const fromBody = new Quaternion().setFromEuler(new Euler(0, -Math.PI / 2, 0));
  const UP = new Vector3(0, 1, 0);
  let isFresh = true;
  const follow = (position: Vector3, attitude: Quaternion, seconds: number) => {
    wanted.set(1, 0, 0).applyQuaternion(attitude);
    wanted.y *= 0.6;
    // Pointing straight up has no direction to follow.
    if (wanted.x * wanted.x + wanted.z * wanted.z > 0.05) {
      wanted.normalize();
      direction.lerp(wanted, isFresh ? 1 : 1 - Math.exp(-seconds / LAG)).normalize();
    }
    isFresh = false;
    side.crossVectors(direction, UP).normalize();
    wanted.copy(direction).applyAxisAngle(UP, own.turn).applyAxisAngle(side, -own.lift);
    // A narrow window needs a larger distance.
    const distance = own.distance * Math.min(1.7, Math.max(1, 1 / camera.aspect));
    camera.position.copy(position).addScaledVector(wanted, -BEHIND * distance);
    camera.position.y += ABOVE * distance;
    camera.position.y = Math.max(camera.position.y, groundHeight(camera.position.x, camera.position.z) + 1);
    camera.up.copy(UP);
    camera.lookAt(
      target
        .copy(position)
        .addScaledVector(wanted, 8)
        .setY(position.y + 8 * wanted.y + 1.4),
    );
  };
  return {
    own,
    reset() {
      isFresh = true;
      Object.assign(own, { turn: 0, lift: 0, distance: 1 });
    },
    update(position, attitude, isCockpit, seconds) {
      camera.fov = isCockpit ? 68 : 55;
      camera.updateProjectionMatrix();
      if (!isCockpit) return follow(position, attitude, seconds);
      camera.position.copy(EYE).applyQuaternion(attitude).add(position);
      camera.quaternion
        .copy(attitude)
        .multiply(fromBody)
        .multiply(turn.setFromEuler(new Euler(-own.lift, own.turn, 0, 'YXZ')));
    },
  };
}
