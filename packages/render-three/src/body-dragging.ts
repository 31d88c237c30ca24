import {
  type BodySource,
  checkOptions,
  type OptionNames,
  placeInPicture,
  ReleaseVelocity,
  sourceOf,
} from '@principia/render-core';
import { type Camera, Plane, Raycaster, Vector2, Vector3 } from 'three';
import { pickBody } from './body-picker.ts';

/** Options and events of dragging. Points are in m and velocities in m/s; copy them to keep them. */
export interface BodyDraggingOptions {
  /** The bodies, by `worldSource`. */
  source: BodySource;
  /** The camera of the picture, which may move. */
  camera: Camera;
  /**
   * The `alpha` that the picture was drawn with, so that a pointer finds a fast body where it is seen: `() => runner.alpha`.
   * Default 1, the present step.
   */
  alpha?(): number;
  /** Whether a body may be grabbed; default all. */
  mayGrab?(id: number): boolean;
  /** A pointer was pressed on body `id`, at `point` of its surface. */
  onGrab?(id: number, point: Vector3, pointerId: number): void;
  /** A pointer that drags `id` moved: the grabbed point belongs at `point`. */
  onDrag?(id: number, point: Vector3, pointerId: number): void;
  /** A pointer released `id` with `velocity`, for throwing. */
  onRelease?(id: number, point: Vector3, velocity: Vector3, pointerId: number): void;
  /** Controls to disable while a body is dragged, such as `OrbitControls`. Default none. */
  controls?: { enabled: boolean };
  /** Distance by which the pointer may miss a body, CSS pixels; default 6. */
  tolerance?: number;
}

/** Pointers that can drag bodies until `destroy()`. */
export interface BodyDragging {
  /** The body under a point of the window, CSS pixels as in a pointer event; 0 for none. */
  pick(clientX: number, clientY: number): number;
  /** Releases at rest what is dragged, and stops listening. */
  destroy(): void;
}

/** A pointer that drags a body. */
interface Grip {
  readonly id: number;
  /** The plane in which the pointer moves the body: facing the camera, or that of a 2D world. */
  readonly plane: Plane;
  readonly point: Vector3;
  readonly velocityXY: ReleaseVelocity;
  readonly velocityZ: ReleaseVelocity;
}

/** Places are parts of the width and the height. */
const WHOLE = { width: 1, height: 1 };

const OPTION_NAMES: OptionNames<BodyDraggingOptions> = {
  source: true,
  camera: true,
  alpha: true,
  mayGrab: true,
  onGrab: true,
  onDrag: true,
  onRelease: true,
  controls: true,
  tolerance: true,
};

/**
 * Lets mouse, pen and touch drag bodies in 3D; several pointers work at once. A body is moved in the plane that faces the camera,
 * or in that of its world if it is a 2D one. Sets `touch-action: none` on `element`, and restores it on `destroy()`.
 *
 * @param element the canvas, or another element of its size
 * @throws Error when there is no source, or an option does not exist
 */
export function listenToBodyDragging(element: HTMLElement, options: BodyDraggingOptions): BodyDragging {
  sourceOf(options, 'listenToBodyDragging');
  checkOptions(options, OPTION_NAMES, 'listenToBodyDragging');
  const dragging = new Dragging(element, options);
  // The capture phase disables controls on the same element before they receive the event.
  element.addEventListener('pointerdown', dragging.down, { capture: true });
  element.addEventListener('pointermove', dragging.move);
  element.addEventListener('pointerup', dragging.up);
  element.addEventListener('pointercancel', dragging.up);
  const { touchAction } = element.style;
  element.style.touchAction = 'none';
  return {
    pick: (clientX, clientY) => dragging.pick(clientX, clientY),
    destroy() {
      element.removeEventListener('pointerdown', dragging.down, { capture: true });
      element.removeEventListener('pointermove', dragging.move);
      element.removeEventListener('pointerup', dragging.up);
      element.removeEventListener('pointercancel', dragging.up);
      element.style.touchAction = touchAction;
      dragging.releaseAll();
    },
  };
}

class Dragging {
  readonly #element: HTMLElement;
  readonly #options: BodyDraggingOptions;
  readonly #grips = new Map<number, Grip>();
  readonly #raycaster = new Raycaster();
  readonly #place = new Vector2();
  readonly #velocity = new Vector3();
  readonly #pick = { id: 0, distance: 0 };
  #controlsWereEnabled = true;

  constructor(element: HTMLElement, options: BodyDraggingOptions) {
    this.#element = element;
    this.#options = options;
  }

  readonly down = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    const id = this.pick(event.clientX, event.clientY);
    if (id === 0 || this.#options.mayGrab?.(id) === false) return;
    this.#element.setPointerCapture(event.pointerId);
    const point = this.#raycaster.ray.at(this.#pick.distance, new Vector3());
    const plane = dragPlane(this.#options, point);
    const grip = { id, plane, point, velocityXY: new ReleaseVelocity(), velocityZ: new ReleaseVelocity() };
    this.#note(grip, event);
    this.#holdControls();
    this.#grips.set(event.pointerId, grip);
    this.#options.onGrab?.(id, point, event.pointerId);
  };

  readonly move = (event: PointerEvent): void => {
    const grip = this.#grips.get(event.pointerId);
    if (grip === undefined) return;
    this.#aim(event.clientX, event.clientY);
    // If the plane is seen edge-on, there is no intersection and the body stays.
    if (this.#raycaster.ray.intersectPlane(grip.plane, grip.point) === null) return;
    this.#note(grip, event);
    this.#options.onDrag?.(grip.id, grip.point, event.pointerId);
  };

  readonly up = (event: PointerEvent): void => {
    const grip = this.#grips.get(event.pointerId);
    if (grip === undefined) return;
    const seconds = event.timeStamp / 1000;
    grip.velocityXY.estimate(seconds);
    grip.velocityZ.estimate(seconds);
    this.#velocity.set(grip.velocityXY.x, grip.velocityXY.y, grip.velocityZ.x);
    this.#release(event.pointerId, grip);
  };

  pick(clientX: number, clientY: number): number {
    const { source, camera, tolerance = 6 } = this.#options;
    this.#aim(clientX, clientY);
    const { ray } = this.#raycaster;
    const alpha = this.#options.alpha?.() ?? 1;
    // A body exactly under the pointer has priority over one that is merely close.
    if (pickBody(source, ray, { alpha, result: this.#pick }) !== 0) return this.#pick.id;
    // Of a perspective camera this is the height of a pixel a metre away, of a parallel one anywhere.
    const pixel = 2 / (camera.projectionMatrix.elements[5] * this.#element.clientHeight);
    const missed = 'isOrthographicCamera' in camera ? { margin: tolerance * pixel } : { slack: tolerance * pixel };
    return pickBody(source, ray, { alpha, ...missed, result: this.#pick });
  }

  /** Releases every body at rest, for example when the element is removed. */
  releaseAll(): void {
    this.#velocity.set(0, 0, 0);
    for (const [pointerId, grip] of this.#grips) this.#release(pointerId, grip);
  }

  #release(pointerId: number, grip: Grip): void {
    this.#grips.delete(pointerId);
    if (this.#grips.size === 0 && this.#options.controls !== undefined) {
      this.#options.controls.enabled = this.#controlsWereEnabled;
    }
    this.#options.onRelease?.(grip.id, grip.point, this.#velocity, pointerId);
  }

  #holdControls(): void {
    const { controls } = this.#options;
    if (controls === undefined || this.#grips.size > 0) return;
    this.#controlsWereEnabled = controls.enabled;
    controls.enabled = false;
  }

  #aim(clientX: number, clientY: number): void {
    const { x, y } = placeInPicture(this.#element, clientX, clientY, WHOLE, this.#place);
    this.#options.camera.updateMatrixWorld();
    this.#raycaster.setFromCamera(this.#place.set(x * 2 - 1, 1 - y * 2), this.#options.camera);
  }

  #note({ point, velocityXY, velocityZ }: Grip, event: PointerEvent): void {
    velocityXY.add(event.timeStamp / 1000, point.x, point.y);
    velocityZ.add(event.timeStamp / 1000, point.z, 0);
  }
}

/** A 3D body moves in the plane through the grabbed point that faces the camera, a 2D one in its world's plane. */
function dragPlane({ source, camera }: BodyDraggingOptions, point: Vector3): Plane {
  const normal = new Vector3(0, 0, 1);
  if (source.dimensions === 2) return new Plane(normal, 0);
  return new Plane().setFromNormalAndCoplanarPoint(camera.getWorldDirection(normal), point);
}
