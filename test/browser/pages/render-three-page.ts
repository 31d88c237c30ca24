/** Page of the three.js renderer tests: scenes built by hand, and statistics of their pixels. */
import {
  AmbientLight,
  Box3,
  Color,
  DirectionalLight,
  Fog,
  HemisphereLight,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  MeshNormalMaterial,
  MeshPhongMaterial,
  MeshStandardMaterial,
  MeshToonMaterial,
  OrthographicCamera,
  PerspectiveCamera,
  PlaneGeometry,
  PointLight,
  Raycaster,
  Scene,
  SphereGeometry,
  SpotLight,
  Vector2,
  Vector3,
  WebGLRenderer,
  type WebGLRendererParameters,
} from 'three';
import { OUTLINE_TEXELS } from '../../../packages/render-core/src/body-source.ts';
import { SHAPES } from '../../../packages/render-core/src/shapes.ts';
import {
  type BodyMeshOptions,
  createBodyMesh,
  createBoxFrame,
  createOrbitCamera,
  createSegmentLines,
  createTrailLines,
  fitRendererToParent,
  listenToBodyDragging,
} from '../../../packages/render-three/src/index.ts';
import { createTestBodySource, type TestBodySource } from '../../support/body-source.ts';

const width = 256;
const height = 192;

export interface Stage {
  renderer: WebGLRenderer;
  scene: Scene;
  camera: PerspectiveCamera | OrthographicCamera;
}

/** Contexts are few: a page has one stage at a time. */
let previous: WebGLRenderer | undefined;

function createStage(
  options: { antialias?: boolean; width?: number; height?: number; depth?: WebGLRendererParameters } = {},
): Stage {
  previous?.dispose();
  previous?.forceContextLoss();
  const renderer = new WebGLRenderer({
    antialias: options.antialias ?? false,
    preserveDrawingBuffer: true,
    ...options.depth,
  });
  previous = renderer;
  renderer.setSize(options.width ?? width, options.height ?? height);
  document.body.replaceChildren(renderer.domElement);
  const scene = new Scene();
  scene.background = new Color(0x000000);
  const camera = new PerspectiveCamera(45, (options.width ?? width) / (options.height ?? height), 0.1, 100);
  camera.position.z = 10;
  return { renderer, scene, camera };
}

/** RGBA bytes of the drawing buffer, bottom row first. */
function pixelsOf({ renderer, scene, camera }: Stage): Uint8Array {
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  const bytes = new Uint8Array(gl.drawingBufferWidth * gl.drawingBufferHeight * 4);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return bytes;
}

export interface BodySketch {
  id: number;
  at: [number, number, number];
  from?: [number, number, number];
  radius?: number;
  color?: number;
  shape?: number;
  angle?: number;
  turn?: [number, number, number, number];
  turnFrom?: [number, number, number, number];
  /** A flat collider: x and y of its vertices, its rounding, and half of its least width. */
  outline?: { vertices: number[]; rounding: number; least: number };
}

function sketch(source: TestBodySource, bodies: BodySketch[]): TestBodySource {
  for (const {
    id,
    at,
    from = at,
    radius = 1,
    color = 0,
    shape = 0,
    angle = 0,
    turn = [0, 0, 0, 0],
    turnFrom,
    outline,
  } of bodies) {
    (['x', 'y', 'z'] as const).forEach((axis, i) => {
      source.position[axis][id] = at[i];
      source.previousPosition[axis][id] = from[i];
    });
    (['x', 'y', 'z', 'w'] as const).forEach((axis, i) => {
      source.orientation[axis][id] = turn[i];
      source.previousOrientation[axis][id] = (turnFrom ?? turn)[i];
    });
    source.angle[id] = angle;
    source.previousAngle[id] = angle;
    source.radius[id] = radius;
    source.color[id] = color;
    source.shape[id] = shape;
    if (outline !== undefined) giveOutline(source, id, radius, outline);
  }
  source.show(bodies.map((body) => body.id));
  return source;
}

/** The body's own outline, by its id. */
function giveOutline(source: TestBodySource, id: number, extent: number, outline: BodySketch['outline'] & {}): void {
  source.outline ??= new Uint32Array(source.rows);
  source.outlines ??= { texels: new Float32Array(1024), used: 1024, version: 1 };
  source.outline[id] = id;
  const { vertices, rounding, least } = outline;
  source.outlines.texels.set([vertices.length / 2, rounding, extent, least, ...vertices], id * OUTLINE_TEXELS);
}

/** Pixels that differ from black, their mean place (from the middle, up positive) and mean colour. */
function lit(pixels: Uint8Array, across: number, threshold = 8) {
  const sum = { count: 0, x: 0, y: 0, r: 0, g: 0, b: 0 };
  for (let i = 0; i < pixels.length; i += 4) {
    if (pixels[i] + pixels[i + 1] + pixels[i + 2] < threshold) continue;
    const pixel = i / 4;
    sum.count++;
    sum.x += (pixel % across) + 0.5 - across / 2;
    sum.y += Math.floor(pixel / across) + 0.5 - pixels.length / 4 / across / 2;
    sum.r += pixels[i];
    sum.g += pixels[i + 1];
    sum.b += pixels[i + 2];
  }
  const n = Math.max(sum.count, 1);
  return { count: sum.count, x: sum.x / n, y: sum.y / n, r: sum.r / n, g: sum.g / n, b: sum.b / n };
}

function differing(a: Uint8Array, b: Uint8Array): number {
  let count = 0;
  for (let i = 0; i < a.length; i += 4) if (a[i] !== b[i] || a[i + 1] !== b[i + 1] || a[i + 2] !== b[i + 2]) count++;
  return count;
}

export interface DrawRequest {
  bodies: BodySketch[];
  alpha?: number;
  dimensions?: 2 | 3;
  precision?: 'f32' | 'f64';
  form?: 'impostor' | 'mesh';
  parallel?: boolean;
  defaultColor?: number;
  origin?: [number, number, number];
}

/** Draws the bodies alone on black, in a page that keeps its stage for the next request. */
function draw(request: DrawRequest): Uint8Array {
  const stage = createStage();
  if (request.parallel) {
    stage.camera = new OrthographicCamera(-4, 4, 3, -3, 0.1, 100);
    stage.camera.position.z = 10;
  }
  const { dimensions = 3, precision = 'f32', form = 'impostor', origin } = request;
  const source = sketch(createTestBodySource(2048, dimensions, precision), request.bodies);
  const options: BodyMeshOptions = { source, form };
  if (request.defaultColor !== undefined) options.defaultColor = request.defaultColor;
  if (form === 'mesh') {
    options.segments = 48;
    stage.scene.add(new AmbientLight(0xffffff, 3));
  }
  const bodies = createBodyMesh(options);
  if (origin !== undefined) {
    bodies.setOrigin(...origin);
    stage.camera.position.add(new Vector3(...origin));
  }
  stage.scene.add(bodies.object);
  bodies.update(request.alpha ?? 1);
  const pixels = pixelsOf(stage);
  bodies.destroy();
  return pixels;
}

function measure(request: DrawRequest) {
  return lit(draw(request), width);
}

/** Number of pixels in which two pictures differ. */
function compare(one: DrawRequest, other: DrawRequest): number {
  return differing(draw(one), draw(other));
}

function pixelAt(request: DrawRequest, x: number, y: number): number[] {
  const at = ((height / 2 + y) * width + width / 2 + x) * 4;
  return Array.from(draw(request).slice(at, at + 3));
}

/** Six steps of bodies with trails; on the way to the last one the context may be lost and restored. */
async function sixSteps(losesContext: boolean): Promise<Uint8Array> {
  const stage = createStage();
  const source = sketch(createTestBodySource(1024, 3), cluster(60));
  const bodies = createBodyMesh({ source });
  const trails = createTrailLines({ source, length: 16 });
  const frame = createBoxFrame(new Box3(new Vector3(-3, -2, -2), new Vector3(3, 2, 2)));
  stage.scene.add(bodies.object, trails.object, frame.object);
  const advance = () => {
    for (const id of source.ids.subarray(0, source.count)) source.position.x[id] += 0.1;
    source.versions.pose++;
    bodies.update(1);
    trails.update(1);
  };
  for (let i = 0; i < 5; i++) {
    advance();
    pixelsOf(stage);
  }
  const restore = losesContext ? await loseContextOf(stage.renderer) : undefined;
  advance();
  await restore?.();
  return pixelsOf(stage);
}

/** Loses the context; what is returned restores it. */
async function loseContextOf(renderer: WebGLRenderer): Promise<() => Promise<unknown>> {
  const extension = renderer.getContext().getExtension('WEBGL_lose_context');
  const event = (name: string) =>
    new Promise((resolve) => renderer.domElement.addEventListener(name, resolve, { once: true }));
  const lost = event('webglcontextlost');
  extension?.loseContext();
  await lost;
  await new Promise((resolve) => setTimeout(resolve));
  return () => {
    const restored = event('webglcontextrestored');
    extension?.restoreContext();
    return restored;
  };
}

async function loseContext(): Promise<{ lit: number; differing: number }> {
  const undisturbed = await sixSteps(false);
  return { lit: lit(undisturbed, width).count, differing: differing(undisturbed, await sixSteps(true)) };
}

function cluster(count: number): BodySketch[] {
  const shapes = [SHAPES.disc, SHAPES.markedDisc, SHAPES.box, SHAPES.ring, SHAPES.glow];
  const colors = [0xff4f6bff, 0xffe0a040, 0xff7ad05a, 0xffff9a5c, 0xff40c8ff];
  return Array.from({ length: count }, (_, i) => {
    const a = i * 2.39996;
    const r = 0.62 * Math.sqrt(i);
    const turn = [Math.sin(i) * 0.5, Math.cos(i * 2) * 0.5, 0.3, 0.6];
    const norm = Math.hypot(...turn);
    return {
      id: i + 1,
      at: [r * Math.cos(a), 0.3 * Math.sin(i * 1.7), r * Math.sin(a)],
      radius: 0.28 + 0.12 * Math.sin(i * 5.1),
      color: colors[i % 5] >>> 0,
      shape: shapes[(i * 3) % 5],
      turn: turn.map((v) => v / norm) as [number, number, number, number],
    } satisfies BodySketch;
  });
}

/** A body on a circle with a trail behind it; statistics with and without the body's own pixels. */
function trail(options: {
  dimensions?: 2 | 3;
  interval?: number;
  alpha?: number;
  listed?: boolean;
  maxSegment?: number;
}) {
  const { dimensions = 3, interval = 1, alpha = 1, listed = false, maxSegment = 1 } = options;
  const stage = createStage();
  const source = sketch(createTestBodySource(1024, dimensions), [{ id: 700, at: [3, 0, 0], color: 0xff00ff00 }]);
  const trails = createTrailLines({
    source,
    length: 40,
    width: 2,
    interval,
    maxSegment,
    ...(listed ? { bodies: [700] } : {}),
  });
  stage.scene.add(trails.object);
  const { position, previousPosition } = source;
  const place = (step: number, isTeleport = false) => {
    previousPosition.x[700] = position.x[700];
    previousPosition.y[700] = position.y[700];
    position.x[700] = 3 * Math.cos(step * 0.05);
    position.y[700] = 3 * Math.sin(step * 0.05);
    if (isTeleport) for (const axis of ['x', 'y'] as const) previousPosition[axis][700] = position[axis][700];
    source.versions.pose++;
    trails.update(alpha);
  };
  for (let step = 0; step <= 30; step++) place(step);
  const pixels = pixelsOf(stage);
  // To the other side of the circle.
  place(31 + Math.round(Math.PI / 0.05), true);
  const afterJump = lit(pixelsOf(stage), width).count;
  trails.history.restart(700);
  place(31);
  const afterRestart = lit(pixelsOf(stage), width).count;
  return { ...lit(pixels, width), top: highest(pixels), afterJump, afterRestart };
}

/** The row of the highest lit pixel, from the middle. */
function highest(pixels: Uint8Array): number {
  for (let i = pixels.length - 4; i >= 0; i -= 4) {
    if (pixels[i + 1] > 40) return Math.floor(i / 4 / width) - height / 2;
  }
  return Number.NaN;
}

/** A horizontal line across the picture through the origin, one end behind the camera when asked. */
function segment(behind: boolean) {
  const stage = createStage();
  const lines = createSegmentLines({ color: 0xffffff, width: 3 });
  stage.scene.add(lines.object);
  if (behind) lines.add(0, -1, 0, 0, -1, 40);
  else lines.add(-2, 0, 0, 2, 0, 0);
  const drawn = lit(pixelsOf(stage), width, 384);
  lines.clear();
  return { drawn, cleared: lit(pixelsOf(stage), width).count };
}

/** The id three's Raycaster finds at a place of the picture, −1 to 1. */
function raycast(bodies: BodySketch[], x: number, y: number, dimensions: 2 | 3 = 3): number[] {
  const stage = createStage();
  const mesh = createBodyMesh({ source: sketch(createTestBodySource(1024, dimensions), bodies) });
  stage.scene.add(mesh.object);
  mesh.update(1);
  stage.camera.updateMatrixWorld();
  const raycaster = new Raycaster();
  raycaster.setFromCamera(new Vector2(x, y), stage.camera);
  const hits = raycaster.intersectObjects(stage.scene.children);
  return hits.map((hit) => hit.instanceId ?? 0);
}

/** A stage with orbit controls and dragging; what happened is in `dragged`. */
const dragged: { events: string[]; camera: number[]; size: number[] } = { events: [], camera: [], size: [] };
function startDragging(bodies: BodySketch[]): void {
  const stage = createStage();
  fitRendererToParent(stage.renderer, stage.camera);
  const source = sketch(createTestBodySource(1024, 3), bodies);
  const mesh = createBodyMesh({ source });
  const element = stage.renderer.domElement;
  const orbit = createOrbitCamera({ element, camera: stage.camera });
  stage.scene.add(mesh.object);
  const say = (name: string, id: number, p: Vector3) =>
    dragged.events.push(`${name} ${id} ${p.toArray().map((v) => v.toFixed(1))}`);
  listenToBodyDragging(element, {
    source,
    camera: stage.camera,
    controls: orbit.controls,
    onGrab: (id, p) => say('grab', id, p),
    onDrag: (id, p) => say('drag', id, p),
    onRelease: (id, p) => say('release', id, p),
  });
  dragged.size = [element.width, element.height];
  const frame = () => {
    orbit.update(1 / 60);
    mesh.update(1);
    stage.renderer.render(stage.scene, stage.camera);
    dragged.camera = stage.camera.position.toArray();
    requestAnimationFrame(frame);
  };
  frame();
}

/**
 * JavaScript time of a frame, ms, with all columns uploaded and two bodies drawn (or all): after a step, the same with
 * `setMatrixAt`, and without a step.
 */
function cost(count: number, drawsAll: boolean, frames = 40) {
  const stage = createStage({ width: 128, height: 128 });
  const rows = Math.ceil((count + 1) / 1024) * 1024;
  const source = createTestBodySource(rows, 3);
  for (let id = 1; id <= count; id++) {
    for (const axis of ['x', 'y', 'z'] as const)
      source.position[axis][id] = 4 * Math.sin(id * (axis === 'x' ? 1 : 1.7));
    source.radius[id] = 0.02;
  }
  source.show(Array.from({ length: count }, (_, i) => i + 1));
  const bodies = createBodyMesh({ source });
  const ours = new Scene().add(bodies.object);
  const instanced = new InstancedMesh(new SphereGeometry(1, 6, 4), new MeshLambertMaterial(), count);
  instanced.frustumCulled = false;
  if (!drawsAll) instanced.count = 2;
  const theirs = new Scene().add(instanced);
  const matrix = new Matrix4();
  const { x, y, z } = source.position;
  const gl = stage.renderer.getContext();
  const pull = () => {
    source.versions.pose++;
    bodies.update(0.5);
    if (!drawsAll) (bodies.object.children[0] as Mesh).geometry.drawRange.count = 12;
    stage.renderer.render(ours, stage.camera);
  };
  const rest = () => {
    bodies.update(0.7);
    stage.renderer.render(ours, stage.camera);
  };
  const push = () => {
    for (let i = 0; i < count; i++) {
      matrix.makeScale(0.02, 0.02, 0.02).setPosition(x[i + 1], y[i + 1], z[i + 1]);
      instanced.setMatrixAt(i, matrix);
    }
    instanced.instanceMatrix.needsUpdate = true;
    stage.renderer.render(theirs, stage.camera);
  };
  return interleaved([pull, push, rest], frames, () =>
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)),
  );
}

/** Median time of each of `jobs`, ms, run in turns; `settle` waits for the GPU between them, unmeasured. */
function interleaved(jobs: (() => void)[], rounds: number, settle: () => void): number[] {
  const times = jobs.map(() => [] as number[]);
  for (let round = 0; round < rounds; round++) {
    jobs.forEach((job, i) => {
      settle();
      const start = performance.now();
      job();
      times[i].push(performance.now() - start);
    });
  }
  return times.map((t) => t.sort((a, b) => a - b)[Math.floor(t.length / 2)]);
}

/** Counts the textures that the context has: also those that three does not know of. */
function countTextures(gl: WebGL2RenderingContext | WebGLRenderingContext): () => number {
  const held = new Set<WebGLTexture | null>();
  const create = gl.createTexture.bind(gl);
  const free = gl.deleteTexture.bind(gl);
  gl.createTexture = () => {
    const texture = create();
    held.add(texture);
    return texture;
  };
  gl.deleteTexture = (texture) => {
    held.delete(texture);
    free(texture);
  };
  return () => held.size;
}

/** Lit pixels of a scene with a shadow of every kind, for each of three's materials; what remains after `destroy`. */
function everyMaterial(form: 'impostor' | 'mesh', depth: WebGLRendererParameters) {
  const stage = createStage({ depth });
  stage.renderer.shadowMap.enabled = true;
  const lights = [
    new DirectionalLight(),
    new PointLight(0xffffff, 20),
    new SpotLight(0xffffff, 20),
    new HemisphereLight(),
  ];
  for (const light of lights) {
    light.position.set(2, 5, 6);
    if (!(light instanceof HemisphereLight)) light.castShadow = true;
  }
  stage.scene.add(...lights);
  stage.scene.fog = new Fog(0x203040, 5, 40);
  const kinds = [
    MeshNormalMaterial,
    MeshBasicMaterial,
    MeshLambertMaterial,
    MeshPhongMaterial,
    MeshToonMaterial,
    MeshStandardMaterial,
  ];
  const source = sketch(createTestBodySource(1024, 3), cluster(10));
  const textures = countTextures(stage.renderer.getContext());
  const held: number[] = [];
  const freed: number[] = [];
  const counts = kinds.map((Kind) => {
    const bodies = createBodyMesh({ source, form, material: new Kind(), castShadow: true, receiveShadow: true });
    const trails = createTrailLines({ source, length: 4, interval: 2 });
    stage.scene.add(bodies.object, trails.object);
    bodies.update(1);
    trails.update(1);
    const { count } = lit(pixelsOf(stage), width);
    stage.scene.remove(bodies.object, trails.object);
    const taken = textures();
    bodies.destroy();
    trails.destroy();
    held.push(textures());
    freed.push(taken - textures());
    return count;
  });
  return { counts, geometries: stage.renderer.info.memory.geometries, held, freed };
}

/** A picture of everything, to look at. */
function gallery(form: 'impostor' | 'mesh', isLit: boolean): void {
  const stage = createStage({ antialias: true, width: 960, height: 600 });
  stage.renderer.shadowMap.enabled = true;
  stage.scene.background = new Color(0x10141c);
  const source = sketch(createTestBodySource(1024, 3), cluster(40));
  const options: BodyMeshOptions = { source, form, castShadow: true, receiveShadow: true };
  if (isLit) options.material = new MeshStandardMaterial({ roughness: 0.5 });
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

/** Balls on orbits in a box, with trails and springs, to look at. */
function orbits(dimensions: 2 | 3): void {
  const stage = createStage({ antialias: true, width: 960, height: 600 });
  stage.scene.background = new Color(0x10141c);
  const source = sketch(
    createTestBodySource(1024, dimensions),
    cluster(40).filter((body) => body.shape !== SHAPES.ring),
  );
  const bodies = createBodyMesh({ source });
  const trails = createTrailLines({ source, length: 60, width: 2 });
  const frame = createBoxFrame(
    new Box3(new Vector3(-5, -5, dimensions === 2 ? 0 : -3), new Vector3(5, 5, dimensions === 2 ? 0 : 3)),
  );
  const springs = createSegmentLines({ color: 0xffe080, width: 1 });
  stage.scene.add(bodies.object, trails.object, frame.object, springs.object);
  for (let step = 0; step < 70; step++) {
    for (let i = 0; i < source.count; i++) {
      const id = source.ids[i];
      const r = 0.7 + 0.1 * id;
      const angle = id * 2.4 + (step * 0.05) / r;
      source.position.x[id] = r * Math.cos(angle);
      source.position.y[id] = r * Math.sin(angle);
      source.position.z[id] = dimensions === 2 ? 0 : r * Math.sin(angle + id) * 0.6;
    }
    source.versions.pose++;
    trails.update(1);
  }
  for (let i = 4; i < source.count; i += 8) {
    const [a, b] = [source.ids[i - 4], source.ids[i]];
    const { x, y, z } = source.position;
    springs.add(x[a], y[a], z[a], x[b], y[b], z[b], 0xff80e0ff, 0xffff8040);
  }
  bodies.update(1);
  const orbit = createOrbitCamera({ element: stage.renderer.domElement, camera: stage.camera });
  if (dimensions === 3) stage.camera.position.set(4, 3, 8);
  orbit.fit(new Box3(new Vector3(-5, -5, -2), new Vector3(5, 5, 2)));
  stage.renderer.render(stage.scene, stage.camera);
}

/** A great many balls, to look at. */
function crowd(count: number): void {
  const stage = createStage({ antialias: true, width: 960, height: 600 });
  stage.scene.background = new Color(0x10141c);
  const source = createTestBodySource(Math.ceil((count + 1) / 1024) * 1024, 3);
  const colors = [0xff4f6bff, 0xffe0a040, 0xff7ad05a, 0xffff9a5c, 0xff40c8ff];
  for (let id = 1; id <= count; id++) {
    const a = id * 2.39996;
    const r = 5 * Math.sqrt(id / count);
    source.position.x[id] = r * Math.cos(a);
    source.position.z[id] = r * Math.sin(a);
    source.position.y[id] = 0.7 * Math.sin(r * 2.2) * Math.cos(a * 3);
    source.radius[id] = 3 / Math.sqrt(count);
    source.color[id] = colors[Math.floor(r * 1.7) % 5];
  }
  source.show(Array.from({ length: count }, (_, i) => i + 1));
  const bodies = createBodyMesh({ source });
  stage.scene.add(bodies.object);
  stage.camera.position.set(0, 5, 8);
  stage.camera.lookAt(0, -0.8, 0);
  bodies.update(1);
  stage.renderer.render(stage.scene, stage.camera);
}

const lab = {
  measure,
  compare,
  pixelAt,
  loseContext,
  trail,
  segment,
  raycast,
  startDragging,
  dragged,
  cost,
  gallery,
  orbits,
  crowd,
  everyMaterial,
};
export type Lab = typeof lab;
Object.assign(globalThis, { lab });
