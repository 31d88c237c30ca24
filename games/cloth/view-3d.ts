/** The 3D view, drawn by three.js. */
import { worldSource } from '@principia/render-core';
import {
  createOrbitCamera,
  fitRendererToParent,
  listenToBodyDragging,
  type OrbitCamera,
} from '@principia/render-three';
import type { View, ViewContext } from '@principia/shell';
import {
  Box3,
  CapsuleGeometry,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  MeshStandardMaterial,
  MOUSE,
  PerspectiveCamera,
  Scene,
  TOUCH,
  Vector3,
  WebGLRenderer,
} from 'three';
import type { JetAxis } from './air-jet.ts';
import { createClothMesh } from './cloth-mesh.ts';
import type { ClothPrint } from './cloth-print.ts';
import { createPlay } from './play.ts';
import type { Settings } from './settings.ts';
import { CLOTH, type ClothRun } from './sim.ts';

const WIDTH = CLOTH.columns * CLOTH.spacing;
const HEIGHT = CLOTH.rows * CLOTH.spacing;
/** Radius within which a pointer takes nodes, m. */
const GRAB_RADIUS = 3 * CLOTH.spacing;

export async function openView3D(context: ViewContext<Settings, ClothRun>, print: ClothPrint): Promise<View> {
  const renderer = new WebGLRenderer({ antialias: true, alpha: true });
  const canvas = renderer.domElement;
  context.element.append(canvas);
  const scenery = createScenery();
  const scene = new Scene().add(...scenery.objects);
  const orbit = createOrbit(canvas, !context.reducedMotion);
  const camera = orbit.camera as PerspectiveCamera;
  let isFitted = true;
  orbit.controls.addEventListener('start', () => {
    isFitted = false;
  });
  const show = () => {
    isFitted = true;
    fitInto(context, viewport, orbit);
  };
  const viewport = fitRendererToParent(renderer, camera, {
    onResize: () => (isFitted ? queueMicrotask(show) : camera.clearViewOffset()),
  });
  let mesh = createClothMesh(context.sim(), context.safeColors);
  scene.add(mesh.object);
  let dragging = listenToHands(context, orbit, canvas);
  const point = new Vector3();
  const toScreen = (x: number, y: number, z: number) => {
    point.set(x, y, z).project(camera);
    return { x: ((point.x + 1) / 2) * viewport.width, y: ((1 - point.y) / 2) * viewport.height };
  };
  const place = (node: number) => {
    const { x, y, z } = context.sim().world.components.Position;
    return toScreen(x[node], y[node], z[node]);
  };
  const play = createPlay(context, canvas, print, place, (x, y) => lineOfSight(camera, viewport, x, y));
  return {
    canvas,
    refresh(change) {
      if (change === 'setting') return;
      dragging.destroy();
      scene.remove(mesh.object);
      mesh.destroy();
      mesh = createClothMesh(context.sim(), context.safeColors);
      scene.add(mesh.object);
      dragging = listenToHands(context, orbit, canvas);
      play.refresh();
    },
    draw(alpha, seconds) {
      orbit.update(seconds);
      play.update(seconds);
      mesh.update(alpha, play.film, print);
      renderer.render(scene, camera);
    },
    fit: show,
    zoom(factor) {
      isFitted = false;
      camera.position.sub(orbit.controls.target).divideScalar(factor).add(orbit.controls.target);
    },
    toScreen(x, y, z) {
      camera.updateMatrixWorld();
      return toScreen(x, y, z);
    },
    destroy() {
      play.destroy();
      for (const part of [dragging, mesh, scenery, orbit, viewport]) part.destroy();
      renderer.dispose();
      renderer.forceContextLoss();
      canvas.remove();
    },
  };
}

/** One finger and the left button belong to the cloth; two fingers and the right button turn the view. */
function createOrbit(element: HTMLElement, hasDamping: boolean): OrbitCamera {
  const orbit = createOrbitCamera({ element, camera: new PerspectiveCamera(32) });
  orbit.camera.position.set(-0.45, -0.12, 1);
  orbit.controls.enableDamping = hasDamping;
  orbit.controls.mouseButtons = { LEFT: null, MIDDLE: MOUSE.PAN, RIGHT: MOUSE.ROTATE };
  orbit.controls.touches = { ONE: null, TWO: TOUCH.DOLLY_ROTATE };
  return orbit;
}

/** Fits the cloth into the part of the window that nothing covers. */
function fitInto(
  context: ViewContext<Settings, ClothRun>,
  { width, height }: { readonly width: number; readonly height: number },
  orbit: OrbitCamera,
): void {
  const camera = orbit.camera as PerspectiveCamera;
  const { top, right, bottom, left } = context.insets();
  const free = { width: Math.max(1, width - left - right), height: Math.max(1, height - top - bottom) };
  camera.clearViewOffset();
  camera.aspect = free.width / free.height;
  camera.updateProjectionMatrix();
  orbit.fit(new Box3(new Vector3(-0.53 * WIDTH, -0.66 * HEIGHT, 0), new Vector3(0.53 * WIDTH, 0.52 * HEIGHT, 0)));
  camera.setViewOffset(free.width, free.height, -left, -top, width, height);
}

/** The rod on which the cloth hangs, and the lamps. */
function createScenery() {
  const geometry = new CapsuleGeometry(0.03, WIDTH + 0.2, 4, 16);
  const material = new MeshStandardMaterial({ color: 0x8fa0e0, roughness: 0.4, metalness: 0.3 });
  const rod = new Mesh(geometry, material);
  rod.rotation.z = Math.PI / 2;
  rod.position.y = (HEIGHT - CLOTH.spacing) / 2 + 0.02;
  const lamp = new DirectionalLight(0xfff1dc, 2.6);
  lamp.position.set(-2, 3, 4);
  const back = new DirectionalLight(0x8fb4ff, 1.2);
  back.position.set(2, 1, -4);
  return {
    objects: [rod, lamp, back, new HemisphereLight(0xdfe6ff, 0x4a4270, 1.1)],
    destroy() {
      geometry.dispose();
      material.dispose();
    },
  };
}

/** A pointer takes all nodes around the one under it. */
function listenToHands(context: ViewContext<Settings, ClothRun>, orbit: OrbitCamera, canvas: HTMLCanvasElement) {
  const { world, cloth } = context.sim();
  const { x, y, z } = world.components.Position;
  return listenToBodyDragging(canvas, {
    source: worldSource(world),
    camera: orbit.camera,
    alpha: context.alpha,
    controls: orbit.controls,
    tolerance: 12,
    onGrab(id, point, pointer) {
      const near = cloth.nodes.filter(
        (node) => Math.hypot(x[node] - x[id], y[node] - y[id], z[node] - z[id]) < GRAB_RADIUS,
      );
      for (const node of near) context.dragging().grab(pointer, node, point.x, point.y, point.z);
    },
    onDrag: (_, point, pointer) => context.dragging().move(pointer, point.x, point.y, point.z),
    onRelease: (_, _point, velocity, pointer) =>
      context.dragging().release(pointer, velocity.x, velocity.y, velocity.z),
  });
}

/** The line from the camera through a place on the canvas, CSS pixels. */
function lineOfSight(
  camera: PerspectiveCamera,
  viewport: { width: number; height: number },
  x: number,
  y: number,
): JetAxis {
  const along = new Vector3((2 * x) / viewport.width - 1, 1 - (2 * y) / viewport.height, 0.5).unproject(camera);
  along.sub(camera.position).normalize();
  return { through: pointOf(camera.position), along: pointOf(along) };
}

const pointOf = ({ x, y, z }: Vector3) => ({ x, y, z });
