/** A view drawn by three.js: canvas, orbit camera, and pointers that drag bodies. A game supplies the picture. */
import { type BodySource, worldSource } from '@principia/render-core';
import {
  createOrbitCamera,
  fitRendererToParent,
  listenToBodyDragging,
  type OrbitCamera,
} from '@principia/render-three';
import {
  Box3,
  type Object3D,
  PerspectiveCamera,
  Plane,
  Raycaster,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import type { Simulation, View, ViewContext } from '../game.ts';
import type { Settings } from '../settings.ts';
import { type CameraKey, createCameraPath } from './camera-path.ts';
import { centreView, fitView } from './fit-view.ts';

/** Degrees; a long lens distorts less than three.js' default. */
const DEFAULT_FIELD_OF_VIEW = 28;

/** A box in the world, m. */
export interface BoxBounds {
  readonly min: { readonly x: number; readonly y: number; readonly z: number };
  readonly max: { readonly x: number; readonly y: number; readonly z: number };
}

/** The drawing of one world. */
export interface ThreePicture {
  /** Added to the scene; coordinates in metres. */
  readonly object: Object3D;
  /** Called once a frame. @param alpha position of the picture between the last two steps, 0 to 1 */
  update(alpha: number): void;
  /** Called when a setting changed. */
  refresh?(): void;
  /** Ends the drawing when its world is replaced. */
  destroy(): void;
}

/** Options of `openThreeView`. */
export interface ThreeViewOptions<Sim extends Simulation> {
  /** The region that must be visible, m. */
  bounds(sim: Sim): BoxBounds;
  /** Creates the picture of a world; called again for every new world. */
  paint(sim: Sim, source: BodySource): ThreePicture;
  /** Direction from the middle of the region to the camera. */
  readonly direction: { readonly x: number; readonly y: number; readonly z: number };
  /**
   * A flight of the camera over the time of the world, until the player takes the camera; `fit` gives it back. Nothing
   * flies where motion is reduced. Default none.
   */
  path?(sim: Sim): readonly CameraKey[] | undefined;
  /** Vertical angle of the picture, degrees; default 28. */
  readonly fieldOfView?: number;
  /** Whether lamps cast shadows; default false. */
  readonly shadows?: boolean;
}

/** A view of three dimensions. */
export interface ThreeView extends View {
  /** The point under a place on the canvas, CSS pixels, in the plane through the middle of the bounds that faces the camera. */
  pointUnder(x: number, y: number): { x: number; y: number; z: number };
}

/**
 * Opens a view in `context`; returned by a renderer's `open`.
 * @throws what three.js throws without WebGL 2, and what `paint` and `path` throw; then nothing of the view stays
 */
export async function openThreeView<S extends Settings, Sim extends Simulation>(
  context: ViewContext<S, Sim>,
  options: ThreeViewOptions<Sim>,
): Promise<ThreeView> {
  const renderer = new WebGLRenderer({ antialias: true, alpha: true });
  context.element.append(renderer.domElement);
  renderer.shadowMap.enabled = options.shadows ?? false;
  try {
    return viewOf(renderer, context, options);
  } catch (error) {
    close(renderer);
    throw error;
  }
}

function close(renderer: WebGLRenderer): void {
  renderer.dispose();
  renderer.forceContextLoss();
  renderer.domElement.remove();
}

function viewOf<S extends Settings, Sim extends Simulation>(
  renderer: WebGLRenderer,
  context: ViewContext<S, Sim>,
  options: ThreeViewOptions<Sim>,
): ThreeView {
  const canvas = renderer.domElement;
  const scene = new Scene();
  let picture = show(context, options, scene);
  let flight = flightOf(context, options);
  const { orbit, camera } = openCamera(canvas, options, context.reducedMotion);
  /** The player has not taken the camera. */
  let isFitted = true;
  const take = () => {
    isFitted = false;
  };
  orbit.controls.addEventListener('start', take);
  const visibleBox = () => {
    const { min, max } = options.bounds(context.sim());
    return new Box3(new Vector3().copy(min), new Vector3().copy(max));
  };
  const fitAll = () => {
    isFitted = true;
    const box = visibleBox();
    fitView(camera, box, viewport, context.insets(), () => orbit.fit(box));
    if (flight !== undefined && !context.reducedMotion) centreView(camera, viewport, context.insets());
  };
  const viewport = fitRendererToParent(renderer, camera, {
    onResize() {
      if (isFitted) queueMicrotask(fitAll);
      else camera.clearViewOffset();
    },
  });
  let dragging = listenTo(context, orbit, canvas);
  return {
    canvas,
    refresh(change) {
      if (change === 'setting') return picture.refresh?.();
      dragging.destroy();
      hide(picture, scene);
      picture = show(context, options, scene);
      dragging = listenTo(context, orbit, canvas);
      flight = flightOf(context, options);
      orbit.controls.enableDamping = !context.reducedMotion;
      if (isFitted) fitAll();
    },
    draw(alpha, seconds) {
      if (isFitted && !context.reducedMotion) flight?.(alpha, camera.position, orbit.controls.target);
      orbit.update(seconds);
      picture.update(alpha);
      renderer.render(scene, camera);
    },
    fit: fitAll,
    ...cameraOf(orbit, take),
    toScreen: (x, y, z) => toScreen(camera, viewport, x, y, z),
    pointUnder: (x, y) => pointUnder(camera, viewport, visibleBox().getCenter(new Vector3()), x, y),
    destroy() {
      dragging.destroy();
      hide(picture, scene);
      orbit.destroy();
      viewport.destroy();
      close(renderer);
    },
  };
}

function openCamera<Sim extends Simulation>(
  element: HTMLElement,
  { fieldOfView = DEFAULT_FIELD_OF_VIEW, direction }: ThreeViewOptions<Sim>,
  reducedMotion: boolean,
): { orbit: OrbitCamera; camera: PerspectiveCamera } {
  const camera = new PerspectiveCamera(fieldOfView);
  const orbit = createOrbitCamera({ element, camera });
  camera.position.copy(direction);
  orbit.controls.enableDamping = !reducedMotion;
  return { orbit, camera };
}

/** What moves the camera on request. @param take is called before: the camera is no longer where it was put */
function cameraOf(
  { camera, controls }: OrbitCamera,
  take: () => void,
): Required<Pick<View, 'zoom' | 'camera' | 'setCamera'>> {
  return {
    zoom(factor) {
      take();
      camera.position.sub(controls.target).divideScalar(factor).add(controls.target);
    },
    camera: () => [...camera.position.toArray(), ...controls.target.toArray()],
    setCamera(numbers) {
      if (numbers.length !== 6 || !numbers.every(Number.isFinite)) return;
      take();
      camera.position.fromArray(numbers, 0);
      controls.target.fromArray(numbers, 3);
    },
  };
}

/** The flight of the camera over the world on display, if there is one: it writes where the camera is and what it sees. */
function flightOf<S extends Settings, Sim extends Simulation>(
  context: ViewContext<S, Sim>,
  options: ThreeViewOptions<Sim>,
): ((alpha: number, eye: Vector3, target: Vector3) => void) | undefined {
  const keys = options.path?.(context.sim());
  if (keys === undefined) return undefined;
  const path = createCameraPath(keys);
  return (alpha, eye, target) => {
    const { world, dt } = context.sim();
    path.at(world.time - (1 - alpha) * dt, eye, target);
  };
}

function show<S extends Settings, Sim extends Simulation>(
  context: ViewContext<S, Sim>,
  options: ThreeViewOptions<Sim>,
  scene: Scene,
): ThreePicture {
  const sim = context.sim();
  const picture = options.paint(sim, worldSource(sim.world));
  scene.add(picture.object);
  return picture;
}

function hide(picture: ThreePicture, scene: Scene): void {
  scene.remove(picture.object);
  picture.destroy();
}

function toScreen(
  camera: PerspectiveCamera,
  { width, height }: { readonly width: number; readonly height: number },
  x: number,
  y: number,
  z: number,
): { x: number; y: number } {
  camera.updateMatrixWorld();
  const place = new Vector3(x, y, z).project(camera);
  return { x: ((place.x + 1) / 2) * width, y: ((1 - place.y) / 2) * height };
}

function pointUnder(
  camera: PerspectiveCamera,
  { width, height }: { readonly width: number; readonly height: number },
  middle: Vector3,
  x: number,
  y: number,
): Vector3 {
  camera.updateMatrixWorld();
  const ray = new Raycaster();
  ray.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), camera);
  const plane = new Plane().setFromNormalAndCoplanarPoint(camera.getWorldDirection(new Vector3()), middle);
  return ray.ray.intersectPlane(plane, new Vector3()) ?? middle;
}

function listenTo<S extends Settings, Sim extends Simulation>(
  context: ViewContext<S, Sim>,
  orbit: OrbitCamera,
  canvas: HTMLCanvasElement,
) {
  return listenToBodyDragging(canvas, {
    source: worldSource(context.sim().world),
    camera: orbit.camera,
    alpha: context.alpha,
    controls: orbit.controls,
    onGrab: (id, point, pointer) => context.dragging().grab(pointer, id, point.x, point.y, point.z),
    onDrag: (_, point, pointer) => context.dragging().move(pointer, point.x, point.y, point.z),
    onRelease: (_, _point, velocity, pointer) =>
      context.dragging().release(pointer, velocity.x, velocity.y, velocity.z),
  });
}
