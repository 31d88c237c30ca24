/** The 3D view, drawn by three.js. */
import { worldSource } from '@principia/render-core';
import {
  type BodyMesh,
  createBodyMesh,
  createOrbitCamera,
  fitRendererToParent,
  type OrbitCamera,
} from '@principia/render-three';
import type { View, ViewContext } from '@principia/shell';
import {
  Color,
  ConstantColorFactor,
  DoubleSide,
  type Material,
  Mesh,
  PerspectiveCamera,
  Plane,
  Raycaster,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import type { PlayerControls } from './controls.ts';
import { createHud } from './hud.ts';
import { createLight3D } from './light-3d.ts';
import { LightClock } from './light-clock.ts';
import type { Settings } from './settings.ts';
import type { FireworksGame } from './sim.ts';
import { listenToSky } from './sky-pointer.ts';
import { createWorld3D } from './world-3d.ts';

/** Target and position of the camera on the shore, m. */
const CENTRE = new Vector3(0, 27, 0);
const EYE = new Vector3(18, 9, 84);
/** Reflectance of the water. */
const REFLECTANCE = 0.45;

export async function openView3D(
  context: ViewContext<Settings, FireworksGame>,
  controls: PlayerControls,
): Promise<View> {
  const renderer = new WebGLRenderer({ antialias: false });
  renderer.autoClear = false;
  const canvas = renderer.domElement;
  context.element.append(canvas);
  const orbit = createOrbit(canvas, !context.reducedMotion);
  const camera = orbit.camera as PerspectiveCamera;
  const scenery = createWorld3D();
  const backdrop = new Scene().add(scenery.object);
  const shining = new Scene();
  const light = createLight3D(renderer, camera);
  const clock = new LightClock();
  let sparks = createSparks(context.sim(), shining);
  const resetCamera = () => placeCamera(orbit);
  const size = new Vector2();
  const viewport = fitRendererToParent(renderer, camera, {
    onResize() {
      renderer.getDrawingBufferSize(size);
      light.resize(size.x, size.y);
    },
  });
  resetCamera();
  const screen = (x: number, y: number, z: number) => {
    camera.updateMatrixWorld();
    const place = new Vector3(x, y, z).project(camera);
    return { x: ((place.x + 1) / 2) * viewport.width, y: ((1 - place.y) / 2) * viewport.height };
  };
  const world = skyPointUnder(camera, viewport);
  const pointer = listenToSky(context, controls, canvas, { world, screen, rotatesView: true });
  const hud = createHud(context, controls);
  const shine = () => sparks.draw(renderer, camera, clock.gain);
  return {
    canvas,
    refresh(change) {
      if (change === 'setting') return;
      sparks.destroy();
      sparks = createSparks(context.sim(), shining);
      clock.reset();
      light.clear();
    },
    draw(alpha, seconds) {
      const sim = context.sim();
      orbit.update(seconds);
      sparks.mesh.update(alpha);
      if (clock.advance(sim, alpha, context.values().glow)) light.add(clock.fade, shine);
      renderer.clear();
      renderer.render(backdrop, camera);
      light.show();
      pointer.update();
      hud.update(seconds, screen);
    },
    fit: resetCamera,
    zoom(factor) {
      camera.position.sub(orbit.controls.target).divideScalar(factor).add(orbit.controls.target);
    },
    toScreen: screen,
    destroy() {
      for (const part of [pointer, hud, sparks, light, scenery, orbit, viewport]) part.destroy();
      renderer.dispose();
      renderer.forceContextLoss();
      canvas.remove();
    },
  };
}

function createOrbit(element: HTMLElement, hasDamping: boolean): OrbitCamera {
  const orbit = createOrbitCamera({ element, camera: new PerspectiveCamera(48, 1, 1, 2000) });
  Object.assign(orbit.controls, { minDistance: 35, maxDistance: 125, maxPolarAngle: 1.75, enablePan: false });
  orbit.controls.enableDamping = hasDamping;
  return orbit;
}

/** Moves the camera to its initial position. */
function placeCamera(orbit: OrbitCamera): void {
  const camera = orbit.camera as PerspectiveCamera;
  orbit.controls.target.copy(CENTRE);
  camera.position.copy(EYE);
  // A narrow window needs a larger distance.
  camera.position
    .sub(CENTRE)
    .multiplyScalar(Math.min(1.25, Math.max(1, 1.5 / camera.aspect)))
    .add(CENTRE);
  orbit.update(0);
}

/** All sparks, drawn directly and as their mirror image in the water. */
function createSparks({ world }: FireworksGame, shining: Scene) {
  const mesh: BodyMesh = createBodyMesh({ source: worldSource(world), minPixelRadius: 1.1 });
  const gain = new Color();
  mesh.object.traverse((part) => {
    if (!(part instanceof Mesh)) return;
    // The gain of a frame multiplies all light; the mirror image is seen from the back.
    Object.assign(part.material as Material, { blendSrc: ConstantColorFactor, blendColor: gain, side: DoubleSide });
  });
  shining.add(mesh.object);
  return {
    mesh,
    draw(renderer: WebGLRenderer, camera: PerspectiveCamera, strength: number) {
      gain.setScalar(strength);
      renderer.render(shining, camera);
      mesh.object.scale.y = -1;
      gain.setScalar(REFLECTANCE * strength);
      renderer.render(shining, camera);
      mesh.object.scale.y = 1;
    },
    destroy() {
      shining.remove(mesh.object);
      mesh.destroy();
    },
  };
}

/**
 * Returns a function that intersects the ray through a point of the canvas with the vertical plane through the centre
 * that faces the camera.
 */
function skyPointUnder(camera: PerspectiveCamera, size: { readonly width: number; readonly height: number }) {
  const ray = new Raycaster();
  const plane = new Plane();
  const facing = new Vector3();
  return (x: number, y: number) => {
    camera.updateMatrixWorld();
    ray.setFromCamera(new Vector2((2 * x) / size.width - 1, 1 - (2 * y) / size.height), camera);
    camera.getWorldDirection(facing).setY(0).normalize();
    plane.setFromNormalAndCoplanarPoint(facing, CENTRE);
    const { x: px, y: py, z: pz } = ray.ray.intersectPlane(plane, new Vector3()) ?? CENTRE;
    return { x: px, y: py, z: pz };
  };
}
