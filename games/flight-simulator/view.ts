/** The picture, drawn by three.js. */
import { columnsOf } from '@principia/physics';
import { fitRendererToParent } from '@principia/render-three';
import type { View, ViewContext } from '@principia/shell';
import {
  CircleGeometry,
  type Material,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Quaternion,
  Scene,
  type Texture,
  Vector3,
  WebGLRenderer,
} from 'three';
import { Deflections } from './aircraft.ts';
import { createAircraftModel } from './aircraft-model.ts';
import { createFlightCamera } from './camera.ts';
import { createGlideLights } from './glide-lights.ts';
import { createHud } from './hud.ts';
import type { Surfaces } from './pilot.ts';
import { listenToPointers } from './pointers.ts';
import { createRingsModel } from './rings-model.ts';
import { addScenery } from './scenery.ts';
import type { Settings } from './settings.ts';
import type { Flight } from './sim.ts';
import { createSounds } from './sounds.ts';
import { groundHeight } from './terrain.ts';

/** Colours of the aeroplane; the second is told apart by everyone. */
const PAINT = { usual: 0xd6402f, safe: 0x0072b2 };
/** Turns of the drawn propeller, rad/s, at full throttle: faster, it would seem to stand still. */
const PROPELLER = 23;

export async function openView(context: ViewContext<Settings, Flight>): Promise<View> {
  const renderer = new WebGLRenderer({ antialias: true });
  const canvas = renderer.domElement;
  context.element.append(canvas);
  const scene = new Scene();
  addScenery(scene);
  const camera = new PerspectiveCamera(55, 1, 0.3, 30_000);
  const flightCamera = createFlightCamera(camera);
  const viewport = fitRendererToParent(renderer, camera);
  const model = createAircraftModel(context.safeColors ? PAINT.safe : PAINT.usual);
  const rings = createRingsModel();
  const glideLights = createGlideLights();
  const shadow = createShadow();
  scene.add(model.object, rings.object, glideLights.object, shadow);
  const hud = createHud(context.element, context.sim, viewport);
  const sounds = createSounds();
  const stopPointers = listenToPointers(context, canvas, flightCamera);
  const pose = { position: new Vector3(), attitude: new Quaternion() };
  const before = new Quaternion();
  const surfaces: Surfaces = { aileron: 0, elevator: 0, rudder: 0 };
  const point = new Vector3();
  let turned = 0;
  const project = (x: number, y: number, z: number) => {
    point.set(x, y, z).applyMatrix4(camera.matrixWorldInverse);
    const ahead = point.z < 0;
    point.applyMatrix4(camera.projectionMatrix);
    return { x: ((point.x + 1) / 2) * viewport.width, y: ((1 - point.y) / 2) * viewport.height, ahead };
  };
  return {
    canvas,
    refresh(change) {
      if (change === 'world') flightCamera.reset();
    },
    draw(alpha, seconds) {
      const flight = context.sim();
      const { cockpit, sound } = context.values();
      readPose(flight, alpha, pose, before);
      readSurfaces(flight, surfaces);
      turned += PROPELLER * (0.2 + 0.8 * flight.pilot.throttle) * seconds;
      model.object.position.copy(pose.position);
      model.object.quaternion.copy(pose.attitude);
      model.update(surfaces, flight.pilot.throttle, context.reducedMotion ? 0 : turned);
      model.seenFrom(cockpit);
      rings.update(flight.log);
      glideLights.update(pose.position);
      placeShadow(shadow, pose.position);
      flightCamera.update(pose.position, pose.attitude, cockpit, seconds);
      camera.updateMatrixWorld();
      renderer.render(scene, camera);
      hud.update(flight, project);
      sounds.update(flight, sound, seconds);
    },
    fit: () => flightCamera.reset(),
    zoom(factor) {
      flightCamera.own.distance = Math.min(6, Math.max(0.4, flightCamera.own.distance / factor));
    },
    toScreen: project,
    destroy() {
      stopPointers();
      for (const part of [hud, sounds, viewport]) part.destroy();
      disposeScene(scene);
      renderer.dispose();
      renderer.forceContextLoss();
      canvas.remove();
    },
  };
}

/** The pose between the last two steps. */
function readPose(
  { world, plane }: Flight,
  alpha: number,
  { position, attitude }: { readonly position: Vector3; readonly attitude: Quaternion },
  before: Quaternion,
): void {
  const { Position: p, Orientation: q } = world.components;
  const { Position: p0, Orientation: q0 } = world.previous;
  const mix = (a: number, b: number) => a + alpha * (b - a);
  position.set(mix(p0.x[plane], p.x[plane]), mix(p0.y[plane], p.y[plane]), mix(p0.z[plane], p.z[plane]));
  before.set(q0.x[plane], q0.y[plane], q0.z[plane], q0.w[plane]);
  attitude.set(q.x[plane], q.y[plane], q.z[plane], q.w[plane]);
  attitude.copy(before.slerp(attitude, alpha));
}

function readSurfaces({ world, plane }: Flight, out: Surfaces): void {
  const { aileron, elevator, rudder } = columnsOf(world, Deflections);
  out.aileron = aileron[plane];
  out.elevator = elevator[plane];
  out.rudder = rudder[plane];
}

/** A dark spot below the aeroplane, by which one judges the height. */
function createShadow(): Mesh<CircleGeometry, MeshBasicMaterial> {
  const material = new MeshBasicMaterial({
    color: 0x10200c,
    transparent: true,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: -6,
    polygonOffsetUnits: -60,
  });
  return new Mesh(new CircleGeometry(1, 24).rotateX(-Math.PI / 2).scale(2.6, 1, 4.2), material);
}

function placeShadow(shadow: Mesh<CircleGeometry, MeshBasicMaterial>, { x, y, z }: Vector3): void {
  const ground = groundHeight(x, z);
  shadow.position.set(x, ground + 0.06, z);
  shadow.material.opacity = 0.34 * Math.max(0, 1 - (y - ground) / 150);
}

function disposeScene(scene: Scene): void {
  (scene.background as Texture | null)?.dispose();
  scene.traverse((part) => {
    if (!(part instanceof Mesh)) return;
    part.geometry.dispose();
    const material = part.material as Material & { readonly map?: Texture | null };
    material.map?.dispose();
    material.dispose();
  });
}
