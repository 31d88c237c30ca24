/** The page of `render-pixi.test.ts`: builds pictures with the pixi layers and hands back their pixels. */
import {
  box,
  capsule,
  createPhysicsWorld,
  despawn,
  polygon,
  rgba,
  rigidBodies,
  type Shape,
  segment,
  spawn,
  step,
} from '@principia/physics';
import { SHAPES, worldSource } from '@principia/render-core';
import {
  applyCamera,
  createBodyLayer,
  createBoxLayer,
  createContactLayer,
  createLinkLayer,
  createSegmentLayer,
  createTrailLayer,
  createWorldContainer,
  keepUpright,
  openScreen,
} from '@principia/render-pixi';
import { AlphaFilter, Application, Container, Graphics, Sprite } from 'pixi.js';
import { createTestBodySource, type TestBodySource } from '../support/body-source.ts';

export type Backend = 'webgl' | 'webgpu';

/** A square picture: RGBA bytes, rows from the top. */
export interface Picture {
  readonly size: number;
  readonly data: Uint8ClampedArray;
}

export const SIZE = 256;

/** A stage with a camera at the world's origin. */
export class Stage {
  readonly app = new Application();
  readonly world = new Container();
  readonly camera = { x: 0, y: 0, pixelsPerMetre: 1 };

  static async open(backend: Backend): Promise<Stage> {
    const stage = new Stage();
    await stage.app.init({
      width: SIZE,
      height: SIZE,
      preference: backend,
      background: 0x000000,
      antialias: false,
      autoStart: false,
      preserveDrawingBuffer: true,
    });
    const name = stage.app.renderer.name;
    if (name !== backend) throw new Error(`asked for ${backend}, got ${name}`);
    document.body.append(stage.app.canvas);
    stage.app.stage.addChild(stage.world);
    return stage;
  }

  /** Renders and reads the picture back. */
  shoot(): Picture {
    applyCamera(this.world, this.camera, { width: SIZE, height: SIZE });
    this.app.render();
    const copy = new OffscreenCanvas(SIZE, SIZE);
    const context = copy.getContext('2d', { willReadFrequently: true });
    if (context === null) throw new Error('no 2D context');
    context.drawImage(this.app.canvas, 0, 0);
    return { size: SIZE, data: context.getImageData(0, 0, SIZE, SIZE).data };
  }

  close(): void {
    this.app.destroy(true, { children: true });
  }
}

/** Sum and centroid of the light in one channel, in full pixels and in pixels from the picture's centre, y up. */
export function light({ data, size }: Picture, channel = 0): { area: number; x: number; y: number } {
  let area = 0;
  let x = 0;
  let y = 0;
  for (let i = 0; i < size * size; i++) {
    const value = data[4 * i + channel] / 255;
    area += value;
    x += value * ((i % size) + 0.5 - size / 2);
    y -= value * (Math.floor(i / size) + 0.5 - size / 2);
  }
  return { area, x: x / area, y: y / area };
}

/** Number of pixels in which two pictures differ by more than `tolerance` of 255 in any channel. */
export function differing(a: Picture, b: Picture, tolerance = 0): number {
  let count = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    let differs = false;
    for (let c = 0; c < 4; c++) if (Math.abs(a.data[i + c] - b.data[i + c]) > tolerance) differs = true;
    if (differs) count++;
  }
  return count;
}

const WHITE = 0xffffffff;

function place(source: TestBodySource, id: number, x: number, y: number, size: number, color = WHITE, angle = 0): void {
  for (const position of [source.position, source.previousPosition]) {
    position.x[id] = x;
    position.y[id] = y;
  }
  source.angle[id] = angle;
  source.previousAngle[id] = angle;
  source.size[id] = size;
  source.color[id] = color;
}

/** One collider of each kind, some 80 m across. */
function colliderShapes(): Shape[] {
  const corners = [0, 1, 2, 3, 4].map((i) => ({ x: 40 * Math.cos(1.25 * i), y: 30 * Math.sin(1.25 * i) }));
  return [
    box(80, 50),
    box(80, 50, { rounding: 15 }),
    capsule(50, 15),
    polygon(corners),
    polygon(corners.slice(0, 3), { rounding: 6 }),
    segment({ x: -40 }, { x: 40 }),
  ];
}

/** All five shapes, some turned, some translucent: a picture worth comparing between back ends. */
function shapeShow(): TestBodySource {
  const source = createTestBodySource(1024);
  const colors = [0xff5ec8ff, 0xff7de08a, 0xffff9f5e, 0xffd98cff, 0xff6ee7ff];
  const kinds = Object.values(SHAPES);
  const ids: number[] = [];
  for (let row = 0; row < 3; row++) {
    for (const [column, kind] of kinds.entries()) {
      const id = 3 + 2 * ids.length;
      place(source, id, (column - 2) * 48, (1 - row) * 70, 20 - 8 * row + 2, colors[(column + row) % 5], 0.4 + row);
      source.shape[id] = kind;
      ids.push(id);
    }
  }
  for (let i = 0; i < 4; i++) {
    const id = 200 + i;
    place(source, id, -60 + 40 * i, 35, 26, 0x66ffffff);
    ids.push(id);
  }
  source.show(ids);
  return source;
}

export const lab = {
  /** A white disc of radius 40 pixels whose centre is off the pixel grid. */
  async disc(backend: Backend, precision: 'f32' | 'f64', far = 0) {
    const stage = await Stage.open(backend);
    const source = createTestBodySource(1024, 2, precision);
    place(source, 5, far + 3.15, -2.6, 20);
    source.show([5]);
    const layer = createBodyLayer({ source });
    layer.setOrigin(far, 0);
    stage.world.addChild(layer.container);
    Object.assign(stage.camera, { x: far, pixelsPerMetre: 2 });
    layer.update(1);
    const result = light(stage.shoot());
    layer.destroy();
    stage.close();
    return result;
  },

  /** What the layers say of a missing source or world, and of an update after they were destroyed. */
  async wrongUse() {
    const source = createTestBodySource(1024, 2, 'f32');
    const layers = [createBodyLayer({ source }), createTrailLayer({ source }), createLinkLayer({ source })];
    const messageOf = (act: () => unknown) => {
      try {
        act();
        return '';
      } catch (error) {
        return String(error);
      }
    };
    const updates = layers.map((layer) => {
      layer.destroy();
      return messageOf(() => layer.update(1));
    });
    const none = {} as never;
    const makers = [createBodyLayer, createTrailLayer, createLinkLayer, createContactLayer, createBoxLayer];
    const refusals = makers.map((make) => messageOf(() => make(none)));
    const screen = await openScreen(undefined as never).catch(String);
    return { updates, refusals, screen };
  },

  /** What a screen makes of options of its context, and what a second destruction throws. */
  async screen() {
    const screen = await openScreen(document.body, { preserveDrawingBuffer: true });
    const attributes = screen.canvas.getContext('webgl2')?.getContextAttributes();
    screen.destroy();
    screen.destroy();
    return { preserves: attributes?.preserveDrawingBuffer, isGone: !screen.canvas.isConnected };
  },

  /** How many pixels of a square, turned by an eighth of a turn, differ from an upright one in a layer without rotation. */
  async unturned(backend: Backend) {
    const stage = await Stage.open(backend);
    const source = createTestBodySource(1024);
    place(source, 1, 0, 0, 40);
    source.shape[1] = SHAPES.box;
    source.show([1]);
    const layer = createBodyLayer({ source, rotation: false });
    // Another layer of the same source, which does turn it.
    const turning = createBodyLayer({ source });
    stage.world.addChild(layer.container);
    const shoot = () => {
      turning.update(1);
      layer.update(1);
      return stage.shoot();
    };
    const upright = shoot();
    source.angle[1] = source.previousAngle[1] = Math.PI / 4;
    source.versions.pose++;
    const differs = differing(upright, shoot());
    stage.close();
    return differs;
  },

  /** Where a moving body is drawn, and which way its mark points, for several alphas. */
  async interpolation(backend: Backend, alphas: number[]) {
    const stage = await Stage.open(backend);
    const source = createTestBodySource(1024);
    place(source, 1, 30, 10, 20, 0xffffffff);
    source.previousPosition.x[1] = -30;
    source.previousPosition.y[1] = -50;
    source.shape[1] = SHAPES.box;
    // From 3.0 to -3.0 rad the shorter way leads through pi, not through zero.
    source.previousAngle[1] = 3.0;
    source.angle[1] = -3.0;
    source.show([1]);
    const layer = createBodyLayer({ source });
    stage.world.addChild(layer.container);
    const shoot = (alpha: number) => {
      layer.update(alpha);
      return light(stage.shoot());
    };
    const positions = alphas.map(shoot);
    source.shape[1] = SHAPES.markedDisc;
    source.versions.style++;
    const marks = alphas.map((alpha) => {
      const { x, y } = shoot(alpha);
      const mark = positions[alphas.indexOf(alpha)];
      return Math.atan2(mark.y - y, mark.x - x);
    });
    stage.close();
    return { positions, marks };
  },

  /**
   * Rims of 2 pixels: the light of a white square of 80 pixels, turned by `angle`, and the darkest and the brightest byte
   * in the middle of the rim of a dark grey disc with a mark.
   */
  async rims(backend: Backend, angle: number) {
    const stage = await Stage.open(backend);
    const source = createTestBodySource(1024);
    const layer = createBodyLayer({ source, rimWidth: 2 });
    stage.world.addChild(layer.container);
    source.show([1]);
    const shoot = (shape: number, color: number) => {
      place(source, 1, 0, 0, 40, color, angle);
      source.shape[1] = shape;
      source.versions.style++;
      layer.update(1);
      return stage.shoot();
    };
    const square = light(shoot(SHAPES.box, WHITE)).area;
    const { data, size } = shoot(SHAPES.markedDisc, 0xff404040);
    let [darkest, brightest] = [255, 0];
    for (let i = 0; i < size * size; i++) {
      const fromEdge = 40 - Math.hypot((i % size) + 0.5 - size / 2, Math.floor(i / size) + 0.5 - size / 2);
      if (fromEdge < 0.5 || fromEdge > 1.5) continue;
      darkest = Math.min(darkest, data[4 * i]);
      brightest = Math.max(brightest, data[4 * i]);
    }
    layer.destroy();
    const wide = createBodyLayer({ source, rimWidth: 20 });
    stage.world.addChild(wide.container);
    source.shape[1] = SHAPES.glow;
    place(source, 1, 0, 0, 40);
    source.versions.style++;
    wide.update(1);
    const glow = light(stage.shoot()).area;
    stage.close();
    return { square, darkest, brightest, glow };
  },

  /** Areas in red, green and blue light for bodies that use each rule for colour and radius. */
  async styles(backend: Backend) {
    const stage = await Stage.open(backend);
    const source = createTestBodySource(1024);
    place(source, 1, -60, 0, 10, 0xff0000ff);
    place(source, 2, 0, 0, 0, 0xff00ff00);
    source.radius[2] = 15;
    source.radius[1] = 99;
    place(source, 3, 60, 0, 20, 0);
    place(source, 4, 0, 80, 0, 0xffffffff);
    source.show([1, 2, 3, 4]);
    const layer = createBodyLayer({ source, defaultColor: 0x0000ff });
    stage.world.addChild(layer.container);
    layer.update(1);
    const picture = stage.shoot();
    const areas = [0, 1, 2].map((channel) => light(picture, channel).area);
    layer.container.alpha = 0.5;
    const faded = light(stage.shoot(), 2).area;
    stage.close();
    return { areas, faded };
  },

  /** Light of every second body of a population that grows and shrinks, as seen by two renderers at once. */
  async population(backend: Backend, counts: number[]) {
    const stage = await Stage.open(backend);
    const source = createTestBodySource(8192);
    const layer = createBodyLayer({ source, rotation: false });
    // A second renderer of the other kind shows the same source and must not get in the way.
    const other = await Stage.open(backend === 'webgl' ? 'webgpu' : 'webgl');
    const twin = createBodyLayer({ source });
    other.world.addChild(twin.container);
    stage.world.addChild(layer.container);
    for (let id = 0; id < 8192; id++) place(source, id, ((id >> 1) % 64) * 4 - 126, (id >> 7) * 4 - 126, 1);
    const lights = counts.map((count) => {
      source.show(Array.from({ length: count }, (_, i) => 2 * i + 1));
      layer.update(1);
      twin.update(1);
      return [light(stage.shoot()).area, light(other.shoot()).area];
    });
    stage.close();
    other.close();
    return lights;
  },

  /** Draws all shapes, loses and restores the context, draws again: how many pixels differ. */
  async contextLoss() {
    const stage = await Stage.open('webgl');
    const layer = createBodyLayer({ source: shapeShow() });
    stage.world.addChild(layer.container);
    layer.update(1);
    const before = stage.shoot();
    const extension = stage.app.canvas.getContext('webgl2')?.getExtension('WEBGL_lose_context');
    if (!extension) throw new Error('the context cannot be lost on purpose');
    const restored = new Promise((resolve) => stage.app.canvas.addEventListener('webglcontextrestored', resolve));
    extension.loseContext();
    await new Promise((resolve) => setTimeout(resolve, 100));
    layer.update(1);
    extension.restoreContext();
    await restored;
    await new Promise((resolve) => setTimeout(resolve, 50));
    layer.update(1);
    const after = stage.shoot();
    stage.close();
    return { lit: light(before).area, differing: differing(before, after) };
  },

  /** Leaves the picture of all shapes on the page for a screenshot. */
  async showShapes(backend: Backend) {
    const stage = await Stage.open(backend);
    const layer = createBodyLayer({ source: shapeShow() });
    stage.world.addChild(layer.container);
    layer.update(1);
    return stage.shoot();
  },

  /** Light of each shape that a collider can have, alone and filled: its area and where it is, beside what they must be. */
  async colliders(backend: Backend) {
    const stage = await Stage.open(backend);
    const seen = colliderShapes().map((shape) => {
      const world = createPhysicsWorld({ capacity: 2000, precision: 'f32' });
      const [x, y] = [12, -7];
      spawn(world, {
        position: { x, y },
        rotation: 0.4,
        collider: { shape },
        appearance: { color: 0xffffffff },
      });
      const layer = createBodyLayer({ source: worldSource(world) });
      stage.world.addChild(layer.container);
      layer.update(1);
      const found = light(stage.shoot());
      layer.destroy();
      return { kind: shape.kind, area: found.area, expected: shape.area, offX: found.x - x, offY: found.y - y };
    });
    stage.close();
    return seen;
  },

  /** Light of the contact points (red) and normals (green) of a box of 80 m that rests on another. */
  async contacts(backend: Backend) {
    const stage = await Stage.open(backend);
    const world = createPhysicsWorld({ capacity: 100, preset: rigidBodies });
    spawn(world, { position: { y: -60 }, collider: { shape: box(200, 80) } });
    spawn(world, { position: { y: 19.998 }, collider: { shape: box(80, 80), density: 1 } });
    step(world, 1 / 60);
    const layer = createContactLayer({
      world,
      pointSize: 9,
      normalLength: 40,
      pointColor: 0xff0000,
      normalColor: 0x00ff00,
    });
    stage.world.addChild(layer.container);
    layer.update();
    const picture = stage.shoot();
    layer.destroy();
    stage.close();
    return { points: light(picture, 0), normals: light(picture, 1) };
  },

  /**
   * Light of the triangle (0, 0), (40, 0), (0, 60) (red) and of a sprite of the same picture, drawn with y down (green),
   * both at (30, 20) and turned by `angle`, in a container with y up.
   */
  async worldContainer(backend: Backend, angle: number) {
    const stage = await Stage.open(backend);
    const own = createWorldContainer();
    stage.world.addChild(own);
    const up = new Graphics().poly([0, 0, 40, 0, 0, 60]).fill(0xff0000);
    const down = new Graphics().poly([0, 0, 40, 0, 0, -60]).fill(0x00ff00);
    const texture = stage.app.renderer.generateTexture({ target: down, resolution: 1 });
    const sprite = keepUpright(new Sprite({ texture, anchor: { x: 0, y: 1 } }));
    const seen = [up, sprite].map((child, channel) => {
      own.removeChildren();
      own.addChild(child);
      child.position.set(30, 20);
      child.rotation = angle;
      return light(stage.shoot(), channel);
    });
    stage.close();
    return seen;
  },

  /** Leaves a picture of all collider shapes, filled with a rim above and as outlines below, on the page. */
  async showColliders(backend: Backend) {
    const stage = await Stage.open(backend);
    const world = createPhysicsWorld({ capacity: 2000 });
    const colors = [0xff5ec8ff, 0xff7de0ff, 0xffff9fff, 0xffd98cff, 0xff6ee7ff, 0xffffffff];
    for (const [i, shape] of colliderShapes().entries()) {
      for (const [row, kind] of [SHAPES.disc, SHAPES.ring].entries()) {
        spawn(world, {
          position: { x: 42 * i - 105, y: 50 - 100 * row },
          rotation: 0.3 * i,
          collider: { shape },
          appearance: { color: colors[i], shape: kind, size: 20 },
        });
      }
    }
    const layer = createBodyLayer({ source: worldSource(world), rimWidth: 2 });
    stage.world.addChild(layer.container);
    layer.update(1);
    return stage.shoot();
  },

  /** Pixels in which WebGL and WebGPU disagree, at all and by more than rounding, and the lit area. */
  async backendsDiffer(show: 'showShapes' | 'showAll' | 'showColliders') {
    const gl = await lab[show]('webgl');
    const gpu = await lab[show]('webgpu');
    return { lit: light(gl).area, exact: differing(gl, gpu), beyondRounding: differing(gl, gpu, 2) };
  },

  /** Texture uploads made by one frame after each kind of change. */
  async uploads() {
    const stage = await Stage.open('webgl');
    const source = shapeShow();
    const first = createBodyLayer({ source });
    const second = createBodyLayer({ source, blendMode: 'add' });
    stage.world.addChild(first.container, second.container);
    const gl = stage.app.canvas.getContext('webgl2') as WebGL2RenderingContext;
    let calls = 0;
    for (const name of ['texImage2D', 'texSubImage2D'] as const) {
      const original = gl[name].bind(gl) as (...args: unknown[]) => void;
      Object.assign(gl, {
        [name]: (...args: unknown[]) => {
          calls++;
          original(...args);
        },
      });
    }
    const frame = () => {
      calls = 0;
      first.update(0.5);
      second.update(0.5);
      stage.app.render();
      return calls;
    };
    const initial = frame();
    const still = frame();
    source.versions.pose++;
    const pose = frame();
    source.versions.style++;
    const style = frame();
    first.destroy();
    source.versions.pose++;
    calls = 0;
    second.update(1);
    stage.app.render();
    const afterDestroy = calls;
    second.destroy();
    stage.close();
    return { initial, still, pose, style, afterDestroy };
  },

  /** A body that goes round a circle of radius 80 with its trail: the light of the trail alone, by quarter turn. */
  async trail(backend: Backend, options: { bodies?: number[]; steps: number; far?: number }) {
    const { bodies, steps, far = 0 } = options;
    const stage = await Stage.open(backend);
    const source = createTestBodySource(2048, 2, far === 0 ? 'f32' : 'f64');
    source.show([7, 1500]);
    const chosen = bodies === undefined ? {} : { bodies };
    const layer = createTrailLayer({ source, length: 33, thickness: 3, opacity: 1, ...chosen });
    const discs = createBodyLayer({ source });
    discs.setOrigin(far, 0);
    stage.world.addChild(layer.container);
    stage.camera.x = far;
    for (let step = 0; step < steps; step++) {
      for (const id of [7, 1500]) {
        const angle = (step / 64) * 2 * Math.PI + (id === 7 ? 0 : Math.PI);
        source.previousPosition.x[id] = source.position.x[id];
        source.previousPosition.y[id] = source.position.y[id];
        source.position.x[id] = far + 80 * Math.cos(angle);
        source.position.y[id] = 80 * Math.sin(angle);
        source.color[id] = id === 7 ? 0xff0000ff : 0xff00ff00;
      }
      source.versions.pose++;
      source.versions.style++;
      layer.update(1);
      if (step % 8 === 0) stage.shoot();
    }
    const picture = stage.shoot();
    const lights = [light(picture, 0), light(picture, 1)];
    source.versions.membership++;
    layer.history.clear();
    layer.update(1);
    const cleared = light(stage.shoot()).area;
    layer.destroy();
    discs.destroy();
    stage.close();
    return { lights, cleared };
  },

  /** Light of a horizontal line 100 pixels long and 6 thick, of a thin one, and of a link at two alphas. */
  async lines(backend: Backend) {
    const stage = await Stage.open(backend);
    const segments = createSegmentLayer({ thickness: 6, color: 0xffffff });
    stage.world.addChild(segments.container);
    segments.set([-50, 20, 50, 20]);
    const thick = light(stage.shoot());
    segments.set([-50, 20, 50, 20, 0, -100, 0, 100], 2, [0xff0000ff, 0xff00ff00]);
    const picture = stage.shoot();
    const colored = [light(picture, 0).area, light(picture, 1).area];
    const many = new Float32Array(4 * 3000);
    for (let i = 0; i < 3000; i++) many.set([(i % 60) * 4 - 118, 5 * Math.floor(i / 60) - 120, 0, 0], 4 * i);
    for (let i = 0; i < 3000; i++) many.set([many[4 * i], many[4 * i + 1]], 4 * i + 2);
    segments.set(many);
    const dots = light(stage.shoot()).area;
    segments.destroy();
    const source = createTestBodySource(1024);
    place(source, 3, -40, 0, 1);
    place(source, 900, 40, 0, 1);
    source.position.y[3] = source.position.y[900] = 60;
    source.show([3, 900]);
    const links = createLinkLayer({ source, thickness: 1, color: 0xffffff });
    links.set([3, 900]);
    stage.world.addChild(links.container);
    const linked = [0, 0.5].map((alpha) => {
      links.update(alpha);
      return light(stage.shoot());
    });
    // Its row is zero, as that of a body that was removed.
    place(source, 900, 0, 0, 0);
    source.show([3]);
    links.update(1);
    const unlinked = light(stage.shoot()).area;
    stage.close();
    return { thick, colored, dots, linked, unlinked };
  },

  /**
   * The light and the box of each kind of layer, and its light through a filter, and through a texture that is cached. Then how
   * far a side of a box moves with a body.
   */
  async boxes(backend: Backend) {
    const stage = await Stage.open(backend);
    const source = createTestBodySource(1024);
    source.show([1, 3]);
    place(source, 1, 50, 20, 10);
    source.shape[1] = SHAPES.box;
    place(source, 3, -30, -60, 4);
    const bodies = createBodyLayer({ source });
    const links = createLinkLayer({ source, thickness: 6 });
    links.set([1, 3]);
    const segments = createSegmentLayer({ thickness: 10 });
    segments.set([-40, 10, 70, 10]);
    const trails = createTrailLayer({ source, thickness: 8, length: 8 });
    for (let step = 0; step < 4; step++) {
      place(source, 1, 50 - 20 * (3 - step), 20, 10);
      source.versions.pose++;
      trails.update(1);
    }
    const seen = [bodies, links, segments, trails].map((layer) => {
      stage.world.addChild(layer.container);
      bodies.update(1);
      links.update(1);
      const plain = stage.shoot();
      const { minX, minY, maxX, maxY } = layer.container.getBounds();
      const box = [minX - SIZE / 2, SIZE / 2 - maxY, maxX - SIZE / 2, SIZE / 2 - minY];
      layer.container.filters = [new AlphaFilter({ alpha: 1 })];
      const filtered = light(stage.shoot()).area;
      layer.container.filters = [];
      layer.container.cacheAsTexture(true);
      const cached = light(stage.shoot()).area;
      layer.container.cacheAsTexture(false);
      layer.container.removeFromParent();
      return { lit: light(plain).area, box, filtered, cached };
    });
    const before = bodies.container.getLocalBounds().maxX;
    place(source, 1, 75, 20, 10);
    source.versions.pose++;
    bodies.update(1);
    const moved = bodies.container.getLocalBounds().maxX - before;
    stage.close();
    return { seen, moved };
  },

  /** The red and the green light of a green disc below a red one of the same place, and with a layer of its own above it. */
  async chosen(backend: Backend) {
    const stage = await Stage.open(backend);
    const world = createPhysicsWorld();
    const disc = (color: number) => spawn(world, { position: {}, appearance: { color, size: 10, shape: SHAPES.disc } });
    const green = disc(rgba(0, 1, 0));
    disc(rgba(1, 0, 0));
    const all = createBodyLayer({ source: worldSource(world) });
    const chosen = createBodyLayer({ source: worldSource(world, { bodies: [green] }) });
    const shoot = () => {
      all.update(1);
      chosen.update(1);
      const picture = stage.shoot();
      return [0, 1].map((channel) => light(picture, channel).area);
    };
    stage.world.addChild(all.container);
    const below = shoot();
    stage.world.addChild(chosen.container);
    const above = shoot();
    despawn(world, green);
    const gone = shoot();
    stage.close();
    return { below, above, gone };
  },

  /** The light of lines and rims under a camera, as they are and by the recipe of docs/drawing.md for a cached texture. */
  async cached(backend: Backend) {
    const stage = await Stage.open(backend);
    stage.camera.pixelsPerMetre = 20;
    const source = createTestBodySource(1024);
    source.show([1]);
    place(source, 1, 2, 2, 1);
    const bodies = createBodyLayer({ source, rimWidth: 3 });
    bodies.update(1);
    const segments = createSegmentLayer({ thickness: 3 });
    segments.set([-3, -2, 3, -2]);
    stage.world.addChild(bodies.container, segments.container);
    const plain = light(stage.shoot()).area;
    const still = new Container({ children: [stage.world] });
    stage.app.stage.addChild(still);
    still.cacheAsTexture(true);
    const cached = light(stage.shoot()).area;
    stage.camera.x = 2;
    stage.shoot();
    still.updateCacheTexture();
    const moved = light(stage.shoot()).x;
    still.cacheAsTexture(false);
    const plainMoved = light(stage.shoot()).x;
    stage.close();
    return { plain, cached, moved, plainMoved };
  },

  /** Leaves a picture with every kind of layer on the page, for a look and for comparing back ends. */
  async showAll(backend: Backend) {
    const stage = await Stage.open(backend);
    const source = createTestBodySource(1024);
    const ids = Array.from({ length: 24 }, (_, i) => i + 1);
    source.show(ids);
    const trails = createTrailLayer({ source, length: 40, thickness: 4, blendMode: 'add' });
    const walls = createSegmentLayer({ thickness: 3, color: 0x556070 });
    walls.set([-120, -110, 120, -110, -120, -110, -120, 110, 120, -110, 120, 110]);
    const links = createLinkLayer({ source, thickness: 1.5, color: 0x8899aa, opacity: 0.6 });
    links.set(ids.slice(1).flatMap((id) => [id - 1, id]));
    const bodies = createBodyLayer({ source });
    stage.world.addChild(walls.container, links.container, trails.container, bodies.container);
    const palette = [0xff5ec8ff, 0xff7de08a, 0xffff9f5e, 0xffd98cff];
    for (let step = 0; step < 60; step++) {
      for (const id of ids) {
        const turn = step * (0.01 + 0.002 * id) + id * 0.8;
        source.previousPosition.x[id] = source.position.x[id];
        source.previousPosition.y[id] = source.position.y[id];
        source.position.x[id] = (20 + 3.4 * id) * Math.cos(turn);
        source.position.y[id] = (18 + 3.2 * id) * Math.sin(turn);
        source.angle[id] = source.previousAngle[id] = turn;
        source.size[id] = 3 + (id % 4) * 2;
        source.shape[id] = id % 5;
        source.color[id] = palette[id % 4];
      }
      source.versions.pose++;
      source.versions.style++;
      trails.update(0.5);
    }
    links.update(0.5);
    bodies.update(0.5);
    return stage.shoot();
  },
};

declare global {
  var pixiLab: typeof lab;
}
globalThis.pixiLab = lab;
