/** Page of the three.js renderer tests: scenes built by hand, and statistics of their pixels. */
import {
  AmbientLight,
  BufferAttribute,
  BufferGeometry,
  type Camera,
  Color,
  DirectionalLight,
  Mesh,
  MeshLambertMaterial,
  MeshStandardMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  WebGLRenderer,
} from 'three';
import { createFakeSource, type FakeSource } from '../../../packages/render-core/src/fake-source.ts';
import { SHAPES } from '../../../packages/render-core/src/shapes.ts';
import { type BodyMesh, type BodyMeshOptions, createBodyMesh } from '../../../packages/render-three/src/index.ts';

const width = 256;
const height = 192;

export interface Stage {
  renderer: WebGLRenderer;
  scene: Scene;
  camera: Camera;
}

let latest: Stage;

function createStage(options: { antialias?: boolean; width?: number; height?: number } = {}): Stage {
  const renderer = new WebGLRenderer({ antialias: options.antialias ?? false, preserveDrawingBuffer: true });
  renderer.setSize(options.width ?? width, options.height ?? height);
  document.body.replaceChildren(renderer.domElement);
  const scene = new Scene();
  scene.background = new Color(0x000000);
  const camera = new PerspectiveCamera(45, (options.width ?? width) / (options.height ?? height), 0.1, 100);
  camera.position.z = 10;
  latest = { renderer, scene, camera };
  return latest;
}

/** RGBA bytes of the drawing buffer, bottom row first. */
function pixelsOf({ renderer, scene, camera }: Stage): Uint8Array {
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  const bytes = new Uint8Array(gl.drawingBufferWidth * gl.drawingBufferHeight * 4);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return bytes;
}

interface BodySketch {
  id: number;
  at: [number, number, number];
  from?: [number, number, number];
  radius?: number;
  color?: number;
  shape?: number;
  angle?: number;
  turn?: [number, number, number, number];
}

function sketch(source: FakeSource, bodies: BodySketch[]): FakeSource {
  for (const { id, at, from = at, radius = 1, color = 0, shape = 0, angle = 0, turn = [0, 0, 0, 0] } of bodies) {
    (['x', 'y', 'z'] as const).forEach((axis, i) => {
      source.position[axis][id] = at[i];
      source.previousPosition[axis][id] = from[i];
    });
    (['x', 'y', 'z', 'w'] as const).forEach((axis, i) => {
      source.orientation[axis][id] = turn[i];
      source.previousOrientation[axis][id] = turn[i];
    });
    source.angle[id] = angle;
    source.previousAngle[id] = angle;
    source.radius[id] = radius;
    source.color[id] = color;
    source.shape[id] = shape;
  }
  source.show(bodies.map((body) => body.id));
  return source;
}

/** A picture of everything, to look at. */
function gallery(form: 'impostor' | 'mesh', lit: boolean): void {
  const stage = createStage({ antialias: true, width: 960, height: 600 });
  stage.renderer.shadowMap.enabled = true;
  stage.scene.background = new Color(0x10141c);
  const source = createFakeSource(1024, 3);
  const bodies: BodySketch[] = [];
  const shapes = [SHAPES.disc, SHAPES.markedDisc, SHAPES.box, SHAPES.ring, SHAPES.glow];
  const colors = [0xff4f6bff, 0xffe0a040, 0xff7ad05a, 0xffff9a5c, 0xff40c8ff].map((c) => c >>> 0);
  for (let i = 0; i < 40; i++) {
    const a = i * 2.39996;
    const r = 0.62 * Math.sqrt(i);
    bodies.push({
      id: i + 1,
      at: [r * Math.cos(a), 0.3 * Math.sin(i * 1.7), r * Math.sin(a)],
      radius: 0.28 + 0.12 * Math.sin(i * 5.1),
      color: colors[i % 5],
      shape: shapes[(i * 3) % 5],
      turn: [Math.sin(i) * 0.5, Math.cos(i * 2) * 0.5, 0.3, 0.6],
    });
  }
  for (const b of bodies) {
    const n = Math.hypot(...(b.turn as number[]));
    b.turn = b.turn?.map((v) => v / n) as [number, number, number, number];
  }
  sketch(source, bodies);
  const options: BodyMeshOptions = { source, form, castShadow: true, receiveShadow: true };
  if (lit) options.material = new MeshStandardMaterial({ roughness: 0.5 });
  const mesh = createBodyMesh(options);
  mesh.update(1);
  const floor = new Mesh(new PlaneGeometry(30, 30), new MeshLambertMaterial({ color: 0x556070 }));
  floor.rotation.x = -Math.PI / 2;
  floor.position.y = -0.9;
  floor.receiveShadow = true;
  const sun = new DirectionalLight(0xffffff, 2.4);
  sun.position.set(-4, 8, 5);
  sun.castShadow = true;
  for (const side of ['left', 'bottom'] as const) sun.shadow.camera[side] = -6;
  for (const side of ['right', 'top'] as const) sun.shadow.camera[side] = 6;
  sun.shadow.mapSize.set(2048, 2048);
  stage.scene.add(mesh.object, floor, sun, new AmbientLight(0xaac0ff, 0.7));
  stage.camera.position.set(0, 5.5, 8.2);
  stage.camera.lookAt(0, -0.3, 0);
  stage.renderer.render(stage.scene, stage.camera);
}

/** Enlarges a part of the last gallery. */
function zoom(x: number, y: number, w: number): void {
  const { renderer, scene, camera } = latest;
  (camera as PerspectiveCamera).setViewOffset(960, 600, x, y, w, (w * 600) / 960);
  renderer.render(scene, camera);
}

const lab = { gallery, zoom };
export type Lab = typeof lab;
Object.assign(globalThis, { lab });
void [BufferAttribute, BufferGeometry, pixelsOf];
export type { BodyMesh };
