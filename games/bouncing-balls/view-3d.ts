/** The 3D view, drawn by three.js. */
import { worldSource } from '@principia/render-core';
import {
  createBodyMesh,
  createOrbitCamera,
  createTrailLines,
  fitRendererToParent,
  listenToBodyDragging,
  type TrailLines,
} from '@principia/render-three';
import type { BouncingBalls } from '@principia/scenes';
import type { View, ViewContext } from '@principia/shell';
import {
  Box3,
  MeshStandardMaterial,
  PerspectiveCamera,
  Plane,
  Raycaster,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import { createPlay } from './play.ts';
import { createRoom3D } from './room-3d.ts';
import type { Settings } from './settings.ts';
import type { BallsRun } from './sim.ts';

/**
 * Number of balls up to which lights and shadows are real; more balls use a cheaper shading that moves with the camera.
 */
const MAX_LIT = 3000;
const MAX_TRAILS = 2000;
/** Degrees; a long lens distorts the room less than three.js' default. */
const FIELD_OF_VIEW = 28;
/** Fraction of the free part of the window that the room fills. */
const FILL_SHARE = 0.95;

export async function openView3D(context: ViewContext<Settings, BallsRun>): Promise<View> {
  const renderer = new WebGLRenderer({ antialias: true, alpha: true });
  const canvas = renderer.domElement;
  context.element.append(canvas);
  renderer.shadowMap.enabled = true;
  const scene = new Scene();
  const orbit = createOrbitCamera({ element: canvas, camera: new PerspectiveCamera(FIELD_OF_VIEW) });
  const camera = orbit.camera as PerspectiveCamera;
  camera.position.set(0.36, 0.2, 1);
  orbit.controls.enableDamping = !context.reducedMotion;
  let picture = createPicture(context, scene);
  let isFitted = true;
  orbit.controls.addEventListener('start', () => {
    isFitted = false;
  });
  const show = () => {
    isFitted = true;
    fitInto(context, viewport, camera, () => orbit.fit(roomBox(context.sim())));
  };
  const viewport = fitRendererToParent(renderer, camera, {
    onResize() {
      if (isFitted) queueMicrotask(show);
      else camera.clearViewOffset();
    },
  });
  let dragging = listenTo(context, orbit, canvas);
  const play = createPlay(context, canvas, pointUnder(context, camera, viewport));
  return {
    canvas,
    refresh(change) {
      if (change === 'setting') {
        picture.showTrails(context.values().trails);
        return;
      }
      dragging.destroy();
      picture.destroy();
      picture = createPicture(context, scene);
      dragging = listenTo(context, orbit, canvas);
      play.refresh();
      if (isFitted) show();
    },
    draw(alpha, seconds) {
      orbit.update(seconds);
      play.update();
      picture.update(alpha);
      renderer.render(scene, camera);
    },
    fit: show,
    zoom(factor) {
      isFitted = false;
      camera.position.sub(orbit.controls.target).divideScalar(factor).add(orbit.controls.target);
    },
    toScreen(x, y, z) {
      camera.updateMatrixWorld();
      const place = new Vector3(x, y, z).project(camera);
      return { x: ((place.x + 1) / 2) * viewport.width, y: ((1 - place.y) / 2) * viewport.height };
    },
    destroy() {
      play.destroy();
      dragging.destroy();
      picture.destroy();
      orbit.destroy();
      viewport.destroy();
      renderer.dispose();
      renderer.forceContextLoss();
      canvas.remove();
    },
  };
}

/** Returns the point under a place on the canvas, in the plane through the middle of the room that faces the camera. */
function pointUnder(
  context: ViewContext<Settings, BallsRun>,
  camera: PerspectiveCamera,
  size: { readonly width: number; readonly height: number },
) {
  const ray = new Raycaster();
  const plane = new Plane();
  const place = new Vector3();
  const pixel = new Vector2();
  return (x: number, y: number) => {
    const centre = roomBox(context.sim()).getCenter(new Vector3());
    camera.updateMatrixWorld();
    ray.setFromCamera(pixel.set((2 * x) / size.width - 1, 1 - (2 * y) / size.height), camera);
    plane.setFromNormalAndCoplanarPoint(camera.getWorldDirection(place), centre);
    return ray.ray.intersectPlane(plane, new Vector3()) ?? centre;
  };
}

function roomBox({ room: { min, max } }: BouncingBalls): Box3 {
  return new Box3(new Vector3(min.x, min.y, min.z), new Vector3(max.x, max.y, max.z));
}

/** Fits the room into the part of the window that nothing covers. */
function fitInto(
  context: ViewContext<Settings, BallsRun>,
  { width, height }: { width: number; height: number },
  camera: PerspectiveCamera,
  fitAll: () => void,
): void {
  const { top, right, bottom, left } = context.insets();
  camera.clearViewOffset();
  const freeWidth = Math.max(width - left - right, 1);
  const freeHeight = Math.max(height - top - bottom, 1);
  camera.zoom = 1;
  camera.aspect = freeWidth / freeHeight;
  camera.updateProjectionMatrix();
  fitAll();
  const { x, y, zoom } = tightFit(camera, roomBox(context.sim()));
  camera.zoom = zoom;
  // The camera was fitted to the free part; the view offset extends the picture to the rest of the window.
  const [offsetX, offsetY] = [x * zoom * freeWidth * 0.5 - left, -y * zoom * freeHeight * 0.5 - top];
  camera.setViewOffset(freeWidth, freeHeight, offsetX, offsetY, width, height);
}

/** Centre of the box in the picture, from -1 to 1, and the zoom that fits it; perspective makes it asymmetric. */
function tightFit(camera: PerspectiveCamera, { min, max }: Box3): { x: number; y: number; zoom: number } {
  camera.updateMatrixWorld();
  const seen = new Box3();
  const corner = new Vector3();
  for (const x of [min.x, max.x]) {
    for (const y of [min.y, max.y]) {
      for (const z of [min.z, max.z]) seen.expandByPoint(corner.set(x, y, z).project(camera));
    }
  }
  const size = seen.getSize(new Vector3());
  const centre = seen.getCenter(new Vector3());
  return { x: centre.x, y: centre.y, zoom: (2 * FILL_SHARE) / Math.max(size.x, size.y) };
}

function listenTo(
  context: ViewContext<Settings, BallsRun>,
  orbit: ReturnType<typeof createOrbitCamera>,
  canvas: HTMLCanvasElement,
) {
  return listenToBodyDragging(canvas, {
    source: worldSource(context.sim().world),
    camera: orbit.camera,
    controls: orbit.controls,
    onGrab: (id, point, pointer) => context.dragging().grab(pointer, id, point.x, point.y, point.z),
    onDrag: (_, point, pointer) => context.dragging().move(pointer, point.x, point.y, point.z),
    onRelease: (_, _point, velocity, pointer) =>
      context.dragging().release(pointer, velocity.x, velocity.y, velocity.z),
  });
}

/** The drawing of one world. */
function createPicture(context: ViewContext<Settings, BallsRun>, scene: Scene) {
  const sim = context.sim();
  const source = worldSource(sim.world);
  const isLit = sim.balls.length <= MAX_LIT;
  const room = createRoom3D(sim, isLit);
  const mesh = createBodyMesh({
    source,
    ...(isLit
      ? { material: new MeshStandardMaterial({ roughness: 0.38 }), castShadow: true, receiveShadow: true }
      : {}),
  });
  scene.add(room.object, mesh.object);
  let trails: TrailLines | undefined;
  const showTrails = (shown: boolean) => {
    if (shown === (trails !== undefined)) return;
    if (trails !== undefined) scene.remove(trails.object);
    trails?.destroy();
    const bodies = sim.balls.subarray(0, MAX_TRAILS);
    trails = shown ? createTrailLines({ source, bodies, length: 48, width: 2.5, opacity: 0.55 }) : undefined;
    if (trails !== undefined) scene.add(trails.object);
  };
  showTrails(context.values().trails);
  return {
    showTrails,
    update(alpha: number) {
      trails?.update(alpha);
      mesh.update(alpha);
    },
    destroy() {
      showTrails(false);
      scene.remove(room.object, mesh.object);
      mesh.destroy();
      room.destroy();
    },
  };
}
