import { checkOptions, type OptionNames } from '@principia/render-core';
import { type Box3, type OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

/** Distance of the camera relative to that at which the bounds just fit. */
const MARGIN = 1.04;

/** Options of `createOrbitCamera`. */
export interface OrbitCameraOptions {
  /** The canvas, or another element that receives the pointer events. */
  element: HTMLElement;
  /** Default: a perspective camera with a vertical angle of 45°, which looks along −z and a little down. */
  camera?: PerspectiveCamera | OrthographicCamera;
  /** Rate at which the view follows a body, 1/s; default 8: two thirds of the distance in an eighth of a second. */
  followRate?: number;
}

/** A camera that turns about a point; drag orbits, wheel and pinch zoom, right button or two fingers pan. */
export interface OrbitCamera {
  /** The camera to render with. */
  readonly camera: PerspectiveCamera | OrthographicCamera;
  /** three's own controls, for all of their settings. */
  readonly controls: OrbitControls;
  /**
   * Targets the centre of `bounds` from the present direction, at the smallest distance that shows all of it; a parallel camera is
   * zoomed. Sets the clip planes.
   * @throws Error when the box is empty
   */
  fit(bounds: Box3): void;
  /**
   * Keeps a point in the middle while the application goes on moving it; `undefined` stops that. The object is read
   * in every `update`, so one vector that the application writes to will do.
   */
  follow(position: { readonly x: number; readonly y: number; readonly z: number } | undefined): void;
  /** Call once a frame with the seconds since the last one. */
  update(seconds: number): void;
  /** Ends the controls; the camera stays as it is. */
  destroy(): void;
}

const OPTION_NAMES: OptionNames<OrbitCameraOptions> = { element: true, camera: true, followRate: true };

/**
 * Creates a camera with three.js' `OrbitControls` on `element`, which glides on after a drag (`controls.enableDamping`).
 * @throws Error when there is no element, or an option does not exist
 */
export function createOrbitCamera(options: OrbitCameraOptions): OrbitCamera {
  if (options?.element === undefined) {
    throw new Error(
      'createOrbitCamera needs the element that hears the pointer: createOrbitCamera({ element: canvas })',
    );
  }
  checkOptions(options, OPTION_NAMES, 'createOrbitCamera');
  const { element, followRate = 8 } = options;
  const camera = options.camera ?? defaultCamera();
  const controls = new OrbitControls(camera, element);
  controls.enableDamping = true;
  const step = new Vector3();
  let followed: { readonly x: number; readonly y: number; readonly z: number } | undefined;
  return {
    camera,
    controls,
    fit(bounds) {
      if (bounds.isEmpty()) throw new Error('fit needs bounds with something in them: the box is empty');
      lookAtBox(camera, controls, bounds);
    },
    follow(position) {
      followed = position;
    },
    update(seconds) {
      if (followed !== undefined) {
        step.set(followed.x, followed.y, followed.z).sub(controls.target);
        step.multiplyScalar(1 - Math.exp(-followRate * seconds));
        controls.target.add(step);
        camera.position.add(step);
      }
      controls.update(seconds);
    },
    destroy() {
      controls.dispose();
    },
  };
}

function defaultCamera(): PerspectiveCamera {
  const camera = new PerspectiveCamera(45, 1, 0.1, 1000);
  camera.position.set(0, 0.35, 1);
  return camera;
}

/** Moves the camera along the present line of sight until the box just fits, and sets the clip planes. */
function lookAtBox(camera: PerspectiveCamera | OrthographicCamera, controls: OrbitControls, box: Box3): void {
  const back = new Vector3().subVectors(camera.position, controls.target);
  if (back.lengthSq() === 0) back.set(0, 0, 1);
  back.normalize();
  const right = new Vector3().crossVectors(camera.up, back);
  if (right.lengthSq() < 1e-12) right.set(1, 0, 0); // straight down
  right.normalize();
  const up = new Vector3().crossVectors(back, right);
  const middle = box.getCenter(controls.target);
  const radius = Math.max(box.min.distanceTo(box.max) / 2, 1e-9);
  let distance = 3 * radius;
  if ('isPerspectiveCamera' in camera) {
    const tangent = Math.tan((camera.fov * Math.PI) / 360);
    const reach = (across: number, upwards: number, near: number) =>
      Math.max(Math.abs(across) / (tangent * camera.aspect), Math.abs(upwards) / tangent) + near;
    distance = furthestCorner(box, middle, right, up, back, reach);
  } else {
    const width = camera.right - camera.left;
    const height = camera.top - camera.bottom;
    const share = (across: number, upwards: number) =>
      Math.max((2 * Math.abs(across)) / width, (2 * Math.abs(upwards)) / height);
    camera.zoom = 1 / Math.max(furthestCorner(box, middle, right, up, back, share), 1e-9);
  }
  distance = Math.max(distance, radius * 1e-3) * MARGIN;
  camera.near = distance / 1000;
  camera.far = (distance + radius) * 100;
  camera.updateProjectionMatrix();
  camera.position.copy(middle).addScaledVector(back, distance);
  controls.update();
}

/** Largest value of `measure` over the corners of the box, relative to its centre along three axes. */
function furthestCorner(
  box: Box3,
  middle: Vector3,
  right: Vector3,
  up: Vector3,
  back: Vector3,
  measure: (across: number, upwards: number, near: number) => number,
): number {
  const corner = new Vector3();
  let largest = 0;
  for (let i = 0; i < 8; i++) {
    corner.set(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z);
    corner.sub(middle);
    largest = Math.max(largest, measure(corner.dot(right), corner.dot(up), corner.dot(back)));
  }
  return largest;
}
