/** The same balls in a room with depth, drawn by three.js. */
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
import type { Stage, View } from '@principia/shell';
import { Box3, MeshStandardMaterial, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import { createRoom3D } from './room-3d.ts';
import type { Settings } from './settings.ts';

/** Most balls with real lights and shadows; more are shaded by a light that moves with the camera. */
const MOST_LIT = 3000;
const MOST_TRAILS = 2000;
/** Degrees; a long lens bends a room less than three's default. */
const FIELD_OF_VIEW = 28;
/** How much of the free part the room fills. */
const FILLED = 0.95;

export async function openView3D(stage: Stage<Settings, BouncingBalls>): Promise<View> {
  const renderer = new WebGLRenderer({ antialias: true, alpha: true });
  const canvas = renderer.domElement;
  stage.element.append(canvas);
  renderer.shadowMap.enabled = true;
  const scene = new Scene();
  const orbit = createOrbitCamera({ element: canvas, camera: new PerspectiveCamera(FIELD_OF_VIEW) });
  const camera = orbit.camera as PerspectiveCamera;
  camera.position.set(0.36, 0.2, 1);
  orbit.controls.enableDamping = !stage.reducedMotion;
  let picture = createPicture(stage, scene);
  let isFitted = true;
  orbit.controls.addEventListener('start', () => {
    isFitted = false;
  });
  const show = () => {
    isFitted = true;
    fitInto(stage, viewport, camera, () => orbit.fit(roomBox(stage.sim())));
  };
  const viewport = fitRendererToParent(renderer, camera, {
    onResize() {
      if (isFitted) queueMicrotask(show);
      else camera.clearViewOffset();
    },
  });
  let dragging = listenTo(stage, orbit, canvas);
  return {
    canvas,
    refresh(change) {
      if (change === 'setting') {
        picture.showTrails(stage.values().trails);
        return;
      }
      dragging.destroy();
      picture.destroy();
      picture = createPicture(stage, scene);
      dragging = listenTo(stage, orbit, canvas);
    },
    draw(alpha, seconds) {
      orbit.update(seconds);
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

function roomBox({ room: { min, max } }: BouncingBalls): Box3 {
  return new Box3(new Vector3(min.x, min.y, min.z), new Vector3(max.x, max.y, max.z));
}

/** Shows what `fitAll` shows in the part of the window that nothing covers. */
function fitInto(
  stage: Stage<Settings, BouncingBalls>,
  { width, height }: { width: number; height: number },
  camera: PerspectiveCamera,
  fitAll: () => void,
): void {
  const { top, right, bottom, left } = stage.insets();
  camera.clearViewOffset();
  const freeWidth = Math.max(width - left - right, 1);
  const freeHeight = Math.max(height - top - bottom, 1);
  camera.zoom = 1;
  camera.aspect = freeWidth / freeHeight;
  camera.updateProjectionMatrix();
  fitAll();
  const { x, y, zoom } = closeUp(camera, roomBox(stage.sim()));
  camera.zoom = zoom;
  // The free part is what the camera was fitted to; the rest of the window shows what lies around it.
  const [offsetX, offsetY] = [x * zoom * freeWidth * 0.5 - left, -y * zoom * freeHeight * 0.5 - top];
  camera.setViewOffset(freeWidth, freeHeight, offsetX, offsetY, width, height);
}

/** Where the box is in the picture, from -1 to 1, and how much closer it could be: near corners make it lopsided. */
function closeUp(camera: PerspectiveCamera, { min, max }: Box3): { x: number; y: number; zoom: number } {
  camera.updateMatrixWorld();
  const seen = new Box3();
  const corner = new Vector3();
  for (const x of [min.x, max.x]) {
    for (const y of [min.y, max.y]) {
      for (const z of [min.z, max.z]) seen.expandByPoint(corner.set(x, y, z).project(camera));
    }
  }
  const size = seen.getSize(new Vector3());
  const middle = seen.getCenter(new Vector3());
  return { x: middle.x, y: middle.y, zoom: (2 * FILLED) / Math.max(size.x, size.y) };
}

function listenTo(
  stage: Stage<Settings, BouncingBalls>,
  orbit: ReturnType<typeof createOrbitCamera>,
  canvas: HTMLCanvasElement,
) {
  return listenToBodyDragging(canvas, {
    source: worldSource(stage.sim().world),
    camera: orbit.camera,
    controls: orbit.controls,
    onGrab: (id, point, pointer) => stage.holding().grab(pointer, id, point.x, point.y, point.z),
    onDrag: (_, point, pointer) => stage.holding().move(pointer, point.x, point.y, point.z),
    onRelease: (_, _point, velocity, pointer) => stage.holding().release(pointer, velocity.x, velocity.y, velocity.z),
  });
}

/** Everything drawn of one world. */
function createPicture(stage: Stage<Settings, BouncingBalls>, scene: Scene) {
  const sim = stage.sim();
  const source = worldSource(sim.world);
  const isLit = sim.balls.length <= MOST_LIT;
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
    const bodies = sim.balls.subarray(0, MOST_TRAILS);
    trails = shown ? createTrailLines({ source, bodies, length: 48, width: 2.5, opacity: 0.55 }) : undefined;
    if (trails !== undefined) scene.add(trails.object);
  };
  showTrails(stage.values().trails);
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
