import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, test } from 'vitest';
import { SHAPES } from '../../packages/render-core/src/shapes.ts';
import { openPage, type ServedPage, servePage } from '../support/page.ts';
import { beforeAllAndRetries, shareBrowser } from '../support/shared-browser.ts';
import type { BodySketch, DrawRequest, Lab } from './pages/render-three-page.ts';

/** The page's stage: 256 × 192 pixels, 45° vertical angle, eye at (0, 0, 10). */
const pixelsPerTangent = 96 / Math.tan(Math.PI / 8);

const browser = shareBrowser();
let served: ServedPage;
let page: Page;
let errors: string[];

beforeAll(async () => {
  served = await servePage(new URL('./pages/render-three-page.ts', import.meta.url));
});

beforeAllAndRetries(async () => {
  ({ page, errors } = await openPage(browser(), served.url));
  page.on('console', (message) => {
    if (message.type() === 'error') errors.push(message.text());
  });
});

afterEach(() => expect(errors).toEqual([]));

afterAll(() => served?.close());

/** Calls a function of the page's lab. */
async function lab<Name extends keyof Lab>(name: Name, ...args: Lab[Name] extends (...a: infer A) => unknown ? A : []) {
  type Result = Lab[Name] extends (...a: never) => infer R ? Awaited<R> : Lab[Name];
  const call = `(typeof lab.${name} === 'function' ? lab.${name}(...${JSON.stringify(args)}) : lab.${name})`;
  return (await page.evaluate(call)) as Result;
}

const measure = (request: DrawRequest) => lab('measure', request);
const white = 0xffffffff;
const ball = (over: Partial<BodySketch> = {}): BodySketch => ({ id: 1, at: [0, 0, 0], color: white, ...over });

describe('the outline of a ball', () => {
  test.each(['impostor', 'mesh'] as const)('has the area of its perspective image (%s)', async (form) => {
    for (const [x, y] of [
      [0, 0],
      [2.5, -1.5],
    ]) {
      const radius = 1.2;
      const distance = Math.hypot(x, y, 10);
      const cone = Math.asin(radius / distance);
      const cosAxis = 10 / distance;
      // The cone of view rays that touch the ball meets the picture plane in an ellipse of this area.
      const area = (Math.PI * Math.sin(cone) ** 2 * Math.cos(cone)) / (cosAxis ** 2 - Math.sin(cone) ** 2) ** 1.5;
      const { count } = await measure({ bodies: [ball({ at: [x, y, 0], radius })], form });
      expect(Math.abs(count / (area * pixelsPerTangent ** 2) - 1)).toBeLessThan(0.02);
    }
  });

  test('is a circle of its radius in a parallel projection', async () => {
    const { count, x, y } = await measure({ bodies: [ball({ at: [1, 0.5, -3], radius: 1.5 })], parallel: true });
    expect(Math.abs(count / (Math.PI * 48 ** 2) - 1)).toBeLessThan(0.02);
    expect(x).toBeCloseTo(32, 0);
    expect(y).toBeCloseTo(16, 0);
  });

  test('of a far ball keeps at least a pixel', async () => {
    const { count } = await measure({ bodies: [ball({ at: [0.3, 0.2, -80], radius: 0.001 })] });
    expect(count).toBeGreaterThanOrEqual(1);
    expect(count).toBeLessThanOrEqual(4);
  });
});

describe('the solid of an outline', () => {
  const metre = 32; // in a parallel projection
  const rounded = Math.hypot(1.5, 0.5) + 0.25;
  test.each([
    ['a plate', { vertices: [-1.5, -0.5, 1.5, -0.5, 1.5, 0.5, -1.5, 0.5], rounding: 0, least: 0.5 }, 1.5812, 3 * 1],
    ['a triangle', { vertices: [-1, -0.5, 1, -0.5, 0, 1], rounding: 0, least: 0.5 }, 1.118, 1.5],
    [
      'a rounded plate',
      { vertices: [-1.5, -0.5, 1.5, -0.5, 1.5, 0.5, -1.5, 0.5], rounding: 0.25, least: 0.75 },
      rounded,
      3.5 * 1.5,
    ],
    ['a capsule', { vertices: [-1, 0, 1, 0], rounding: 0.5, least: 0.5 }, 1.5, 2 * 1 + Math.PI * 0.25],
  ])('has the area of the collider: %s', async (_, outline, radius, area) => {
    for (const angle of [0, 1]) {
      const bodies = [ball({ at: [0.2, 0.1, 0], radius, angle, outline })];
      const { count, x } = await measure({ bodies, parallel: true, dimensions: 2 });
      expect(Math.abs(count / (area * metre ** 2) - 1)).toBeLessThan(0.03);
      if (outline.vertices.length !== 6) expect(x).toBeCloseTo(0.2 * metre, 0);
    }
  });

  test('is as thick as it is narrow: a plate seen from the side', async () => {
    const outline = { vertices: [-1.5, -0.5, 1.5, -0.5, 1.5, 0.5, -1.5, 0.5], rounding: 0, least: 0.5 };
    const bodies = [ball({ radius: 1.5812, turn: [Math.SQRT1_2, 0, 0, Math.SQRT1_2], outline })];
    const { count } = await measure({ bodies, parallel: true });
    expect(Math.abs(count / (3 * 1 * metre ** 2) - 1)).toBeLessThan(0.03);
  });
});

describe('what is drawn', () => {
  test('alpha blends the previous step into the present one, also along the depth', async () => {
    const bodies = [ball({ from: [-2, 0, 0], at: [2, 1, 0], radius: 0.5 })];
    const places = await Promise.all([0, 0.5, 1].map(async (alpha) => (await measure({ bodies, alpha })).x));
    const metre = pixelsPerTangent / 10;
    places.forEach((x, i) => {
      expect(x).toBeCloseTo([-2, 0, 2][i] * metre, -0.3);
    });
    const nearing = [ball({ from: [0, 0, -10], at: [0, 0, 5] })];
    expect((await measure({ bodies: nearing, alpha: 0 })).count).toBeLessThan(
      (await measure({ bodies: nearing, alpha: 1 })).count / 10,
    );
  });

  test('only the listed ids, with holes between them, from every row of the textures', async () => {
    const bodies = [3, 1023, 1024, 2000].map((id, i) => ball({ id, at: [i * 2 - 3, 0, 0], radius: 0.5 }));
    const one = (await measure({ bodies: [ball({ id: 5, radius: 0.5 })] })).count;
    const four = await measure({ bodies });
    expect(four.count / one).toBeCloseTo(4, 0);
    expect(Math.abs(four.x)).toBeLessThan(0.5);
  });

  test('nothing for a body without radius', async () => {
    expect((await measure({ bodies: [ball({ radius: 0 })] })).count).toBe(0);
  });

  test('an f64 world looks the same, and keeps its millimetres near an origin far away', async () => {
    const bodies = [ball({ from: [-1, 0, 0], at: [1.1, 0.3, 0] }), ball({ id: 7, at: [0, -1, 1], shape: 3 })];
    expect(await lab('compare', { bodies, alpha: 0.5 }, { bodies, alpha: 0.5, precision: 'f64' })).toBe(0);
    const far = [ball({ at: [1e9 + 1, 0, 0], radius: 0.5 })];
    const near = [ball({ at: [1, 0, 0], radius: 0.5 })];
    const moved = { bodies: far, precision: 'f64', origin: [1e9, 0, 0] } as const;
    expect(await lab('compare', { bodies: near }, { ...moved, origin: [...moved.origin] })).toBe(0);
  });

  test('a 2D world in the plane z = 0, turned by its angles', async () => {
    const square = (angle: number): DrawRequest => ({
      dimensions: 2,
      parallel: true,
      bodies: [ball({ shape: SHAPES.box, angle, radius: 1, at: [0.5, 0.5, 7] })],
    });
    const flat = await measure(square(0));
    expect(Math.abs(flat.count / 64 ** 2 - 1)).toBeLessThan(0.02);
    expect(flat.x).toBeCloseTo(16, 0);
    expect((await measure(square(Math.PI / 4))).count / 64 ** 2).toBeCloseTo(1, 1);
    expect(await lab('compare', square(0), square(Math.PI / 4))).toBeGreaterThan(500);
    expect(await lab('compare', square(0), square(Math.PI / 2))).toBe(0);
  });

  test.each(['impostor', 'mesh'] as const)('its own colour, or the default where it has none (%s)', async (form) => {
    const red = await measure({ bodies: [ball({ color: 0xff0000ff })], form });
    expect(red.r).toBeGreaterThan(100);
    expect(red.g + red.b).toBeLessThan(10);
    const green = await measure({ bodies: [ball({ color: 0 })], defaultColor: 0x00ff00, form });
    expect(green.g).toBeGreaterThan(100);
    expect(green.r + green.b).toBeLessThan(10);
  });
});

describe('depth', () => {
  const red = ball({ id: 1, at: [0, 0, 1], color: 0xff0000ff });
  const blue = ball({ id: 2, at: [0, 0, -1], color: 0xffff0000, radius: 1.5 });

  test.each(['impostor', 'mesh'] as const)('the nearer ball covers the other, whatever its id (%s)', async (form) => {
    const [r, , b] = await lab('pixelAt', { bodies: [red, blue], form }, 0, 0);
    expect([r > 100, b < 10]).toEqual([true, true]);
    const swapped = [
      { ...red, id: 2 },
      { ...blue, id: 1 },
    ].reverse();
    expect(await lab('compare', { bodies: [red, blue], form }, { bodies: swapped, form })).toBe(0);
  });

  test('two balls that cut each other meet half way', async () => {
    const bodies = [ball({ at: [-0.5, 0, 0], color: 0xff0000ff }), ball({ id: 2, at: [0.5, 0, 0], color: 0xffff0000 })];
    const [left, right] = await Promise.all([lab('pixelAt', { bodies }, -3, 0), lab('pixelAt', { bodies }, 3, 0)]);
    expect([left[0] > 60, left[2] < 10, right[0] < 10, right[2] > 60]).toEqual([true, true, true, true]);
  });
});

describe('depth of the surface', () => {
  test.each(['impostor', 'mesh'] as const)('a ball inside another is hidden by its surface (%s)', async (form) => {
    const outer = ball({ id: 1, radius: 2, color: 0xff0000ff });
    const inner = ball({ id: 2, at: [0.4, 0, 1], radius: 0.5, color: 0xffff0000 });
    expect(await lab('compare', { bodies: [outer], form }, { bodies: [outer, inner], form })).toBe(0);
  });
});

describe('rotation', () => {
  const half = Math.SQRT1_2;
  test.each(['impostor', 'mesh'] as const)(
    'shows on a marked body and a box, not on a plain ball (%s)',
    async (form) => {
      const turned = (shape: number, turn: [number, number, number, number]): DrawRequest => ({
        form,
        bodies: [ball({ shape, turn, color: 0xff2080ff, radius: 1.5 })],
      });
      const changed = (shape: number) =>
        lab('compare', turned(shape, [0, 0, 0, 0]), turned(shape, [Math.sin(0.4), 0, 0, Math.cos(0.4)]));
      expect(await changed(SHAPES.markedDisc)).toBeGreaterThan(500);
      expect(await changed(SHAPES.box)).toBeGreaterThan(500);
      if (form === 'impostor') expect(await changed(SHAPES.disc)).toBe(0);
    },
  );

  test('a quaternion of zeros is no rotation, and q is the rotation that −q is', async () => {
    const at = (turn: [number, number, number, number]): DrawRequest => ({
      bodies: [ball({ shape: SHAPES.markedDisc, turn, color: 0xff2080ff })],
    });
    expect(await lab('compare', at([0, 0, 0, 0]), at([0, 0, 0, 1]))).toBe(0);
    expect(await lab('compare', at([0, half, 0, half]), at([0, -half, 0, -half]))).toBeLessThan(3);
    const between = (turn: [number, number, number, number]): DrawRequest => ({
      bodies: [ball({ shape: SHAPES.markedDisc, turnFrom: [0, 0, 0, 1], turn, color: 0xff2080ff })],
      alpha: 0.5,
    });
    expect(await lab('compare', between([0, half, 0, half]), between([0, -half, 0, -half]))).toBeLessThan(3);
    const quarter = Math.PI / 8;
    const middle = at([0, Math.sin(quarter), 0, Math.cos(quarter)]);
    expect(await lab('compare', between([0, half, 0, half]), middle)).toBeLessThan(3);
  });
});

test('an outline leaves the middle free and a glow adds light to what is behind it', async () => {
  const back = ball({ id: 1, at: [0, 0, -3], radius: 2, color: 0xff000080 });
  const glow = ball({ id: 2, at: [0, 0, 0], shape: SHAPES.glow, color: 0xff00ff00 });
  const [r, g] = await lab('pixelAt', { bodies: [back, glow] }, 0, 0);
  expect([r > 40, g > 150]).toEqual([true, true]);
  const ring = await measure({ bodies: [ball({ shape: SHAPES.ring, radius: 2 })] });
  const disc = await measure({ bodies: [ball({ radius: 2 })] });
  expect(ring.count / disc.count).toBeGreaterThan(0.15);
  expect(ring.count / disc.count).toBeLessThan(0.35);
});

test('a lost context comes back with the same picture', async () => {
  const { lit, differing } = await lab('loseContext');
  expect(lit).toBeGreaterThan(4000);
  expect(differing).toBe(0);
});

test.each([
  ['impostor', {}],
  ['mesh', {}],
  ['impostor', { logarithmicDepthBuffer: true }],
  ['impostor', { reversedDepthBuffer: true }],
] as const)(
  "all of three's lit materials, that of normals, lights and shadows work (%s, %o), and destroy frees what they took",
  async (form, depth) => {
    const { counts, geometries, held, freed } = await lab('everyMaterial', form, depth);
    expect(Math.min(...counts)).toBeGreaterThan(1000);
    expect(Math.max(...counts) / Math.min(...counts)).toBeLessThan(1.1);
    expect(geometries).toBe(0);
    // What three makes for itself stays: shadow maps, and its table of reflections with the last material.
    expect(new Set(held.slice(0, -1)).size).toBe(1);
    // Six columns of places and eight of rotations, now and a step ago, ids and styles; trails have theirs.
    expect(Math.min(...freed)).toBeGreaterThanOrEqual(16);
  },
);

describe('lines', () => {
  test.each([
    { dimensions: 3, interval: 1 },
    { dimensions: 2, interval: 4, listed: true },
  ] as const)('a trail follows its body and fades (%o)', async (options) => {
    const trail = await lab('trail', options);
    const metre = pixelsPerTangent / 10;
    // Thirty steps of 0.05 rad on a circle of 3 m, two pixels wide and fading.
    const length = 30 * 0.05 * 3 * metre;
    expect(trail.count).toBeGreaterThan(length * 1.5);
    expect(trail.count).toBeLessThan(length * 4);
    expect(trail.g).toBeGreaterThan(40);
    expect(trail.r + trail.b).toBe(0);
    expect(trail.top).toBeCloseTo(3 * Math.sin(30 * 0.05) * metre, -0.8);
    if (options.interval === 1) expect(trail.afterRestart).toBe(0);
  });

  test('a trail ends where its body is drawn between two steps', async () => {
    const [previous, present] = [await lab('trail', { alpha: 0 }), await lab('trail', { alpha: 1 })];
    expect(previous.count).toBeLessThan(present.count);
    const sparse = [await lab('trail', { alpha: 0, interval: 4 }), await lab('trail', { alpha: 1, interval: 4 })];
    expect(sparse[0].count).toBeLessThan(sparse[1].count);
  });

  test.each([1, 2])('a trail has a gap where its body was teleported, every %d poses', async (interval) => {
    for (const alpha of [0.1, 0.9]) {
      const { count, afterJump } = await lab('trail', { alpha, interval });
      const joined = await lab('trail', { alpha, interval, maxSegment: 10 });
      // The points before the jump fade by one more; a line through the whole circle has 6 m.
      expect(Math.abs(afterJump / count - 1), `alpha ${alpha}`).toBeLessThan(0.1);
      if (alpha > 0.5) expect(joined.afterJump - afterJump).toBeGreaterThan((4 * pixelsPerTangent) / 10);
    }
  });

  test('a segment has its length and width, is cleared, and may end behind the eye', async () => {
    const { drawn, cleared } = await lab('segment', false);
    const length = (4 * pixelsPerTangent) / 10;
    expect(drawn.count / (3 * length)).toBeGreaterThan(0.6);
    expect(drawn.count / (3 * length)).toBeLessThan(1.1);
    expect(cleared).toBe(0);
    const behind = await lab('segment', true);
    expect(Math.abs(behind.drawn.x)).toBeLessThan(2);
    expect(behind.drawn.y).toBeLessThan(-20);
  });
});

test('three finds bodies with its own Raycaster', async () => {
  const bodies = [ball({ id: 9 }), ball({ id: 4, at: [0, 0, 3] }), ball({ id: 6, at: [3, 0, 0], radius: 0.5 })];
  expect(await lab('raycast', bodies, 0, 0)).toEqual([4]);
  expect(await lab('raycast', bodies, 3 / (10 * Math.tan(Math.PI / 8) * (256 / 192)), 0)).toEqual([6]);
  expect(await lab('raycast', bodies, -0.9, 0.9)).toEqual([]);
});

test('a body is dragged in the plane facing the camera while the orbit rests, and thrown', async () => {
  await page.setViewportSize({ width: 400, height: 400 });
  await page.evaluate('document.body.style.cssText = "margin:0;height:400px"');
  await lab('startDragging', [ball({ id: 3, radius: 1 })]);
  await page.waitForTimeout(100);
  await page.mouse.move(200, 200);
  await page.mouse.down();
  await page.mouse.move(240, 200, { steps: 4 });
  await page.mouse.up();
  const { events, camera, size } = await lab('dragged');
  expect(size).toEqual([400, 400]);
  expect(events[0]).toBe('grab 3 0.0,0.0,1.0');
  const reach = ((40 / 200) * 9 * Math.tan(Math.PI / 8)).toFixed(1);
  expect(events.at(-2)).toBe(`drag 3 ${reach},0.0,1.0`);
  expect(events.at(-1)).toBe(`release 3 ${reach},0.0,1.0`);
  expect(camera.map((v) => Math.round(v * 1e3) / 1e3)).toEqual([0, 0, 10]);
  // Beside the body the drag turns the camera.
  await page.mouse.move(40, 40);
  await page.mouse.down();
  await page.mouse.move(90, 40, { steps: 3 });
  await page.mouse.up();
  await page.waitForTimeout(100);
  const after = await lab('dragged');
  expect(after.events.length).toBe(events.length);
  expect(Math.abs(after.camera[0])).toBeGreaterThan(1);
});

test('a frame of 100 000 bodies costs a fraction of setting their matrices', async () => {
  const [pull, push] = await lab('cost', 100_000, false, 30);
  console.info(`100 000 bodies, JavaScript a frame: ${pull.toFixed(2)} ms pulled, ${push.toFixed(2)} ms setMatrixAt`);
  expect(push / pull).toBeGreaterThan(2);
});
