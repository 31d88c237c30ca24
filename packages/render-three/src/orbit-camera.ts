import { type Box3, type OrthographicCamera, PerspectiveCamera, Sphere, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

/** What `createOrbitCamera` may be told. */
export interface OrbitCameraOptions {
  /** The canvas, or whatever element the pointers are on. */
  element: HTMLElement;
  /** Default: a perspective camera with a vertical angle of 45°, which looks along −z and a little down. */
  camera?: PerspectiveCamera | OrthographicCamera;
  /** How fast the view catches up with a followed body, 1/s; default 8: two thirds of the way in an eighth of a second. */
  followRate?: number;
}

/** A camera that turns about a point; drag orbits, wheel and pinch zoom, right button or two fingers pan. */
export interface OrbitCamera {
  readonly camera: PerspectiveCamera | OrthographicCamera;
  /** three's own controls, for all of their settings. */
  readonly controls: OrbitControls;
  /** Looks at the middle of `bounds` from the present direction, just far enough away to see all of it. */
  fit(bounds: Box3): void;
  /**
   * Keeps a point in the middle while the application goes on moving it; `undefined` stops that. The object is read
   * in every `update`, so one vector that the application writes to will do.
   */
  follow(position: { readonly x: number; readonly y: number; readonly z: number } | undefined): void;
  /** Call once a frame with the seconds since the last one. */
  update(seconds: number): void;
  destroy(): void;
}

/** Makes a camera with three's `OrbitControls` on `element`. */
export function createOrbitCamera(options: OrbitCameraOptions): OrbitCamera {
  const { element, followRate = 8 } = options;
  const camera = options.camera ?? defaultCamera();
  const controls = new OrbitControls(camera, element);
  controls.enableDamping = true;
  const step = new Vector3();
  const sphere = new Sphere();
  let followed: { readonly x: number; readonly y: number; readonly z: number } | undefined;
  return {
    camera,
    controls,
    fit(bounds) {
      if (bounds.isEmpty()) throw new Error('fit needs bounds with something in them: the box is empty');
      bounds.getBoundingSphere(sphere);
      sphere.radius = Math.max(sphere.radius, 1e-9);
      lookAtSphere(camera, controls, sphere, step);
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

/** Moves along the present line of sight until the sphere just fits, and puts the clip planes about it. */
function lookAtSphere(
  camera: PerspectiveCamera | OrthographicCamera,
  controls: OrbitControls,
  sphere: Sphere,
  direction: Vector3,
): void {
  direction.copy(camera.position).sub(controls.target);
  if (direction.lengthSq() === 0) direction.set(0, 0, 1);
  direction.normalize();
  let distance = 3 * sphere.radius;
  if ('isPerspectiveCamera' in camera) {
    const vertical = (camera.fov * Math.PI) / 360;
    const horizontal = Math.atan(Math.tan(vertical) * camera.aspect);
    distance = sphere.radius / Math.sin(Math.min(vertical, horizontal));
  } else {
    const { left, right, top, bottom } = camera;
    camera.zoom = Math.min(right - left, top - bottom) / (2 * sphere.radius);
  }
  camera.near = distance / 1000;
  camera.far = distance * 100;
  camera.updateProjectionMatrix();
  controls.target.copy(sphere.center);
  camera.position.copy(sphere.center).addScaledVector(direction, distance);
  controls.update();
}
