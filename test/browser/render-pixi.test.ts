import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { openPage, type ServedPage, servePage } from '../support/page.ts';
import { beforeAllAndRetries, shareBrowser } from '../support/shared-browser.ts';
import type { Backend } from './render-pixi.page.ts';

const browser = shareBrowser();
let served: ServedPage;
let page: Page;
let errors: string[];

beforeAll(async () => {
  served = await servePage(new URL('./render-pixi.page.ts', import.meta.url));
});

afterAll(() => served?.close());

/** Gives the tests of the surrounding block a page: a browser lets one page have only so many WebGL contexts. */
function useFreshPage(): void {
  beforeAllAndRetries(async () => {
    ({ page, errors } = await openPage(browser(), served.url));
    await page.waitForFunction(() => 'pixiLab' in globalThis);
  });

  afterAll(async () => {
    await page.close();
    expect(errors).toEqual([]);
  });
}

/** A test takes a second; once in some hundred, Chromium's WebGPU in software hangs and never comes back. */
const HANGS = { timeout: 60_000, retry: 2 };

const discArea = (radius: number) => Math.PI * radius ** 2;

describe.each<Backend>(['webgl', 'webgpu'])('bodies with %s', HANGS, (backend) => {
  useFreshPage();

  it.each(['f32', 'f64'] as const)('draws a disc of the right area in the right place, %s', async (precision) => {
    const seen = await page.evaluate(([b, p]) => pixiLab.disc(b, p), [backend, precision] as const);
    expect(seen.area / discArea(40)).toBeCloseTo(1, 2);
    expect(seen.x).toBeCloseTo(6.3, 1);
    expect(seen.y).toBeCloseTo(-5.2, 1);
  });

  it('says what is missing, and that a layer was destroyed', async () => {
    const { updates, refusals, screen } = await page.evaluate(() => pixiLab.wrongUse());
    for (const message of updates) expect(message).toMatch(/this layer \(principia-\w+\) was destroyed/);
    expect(refusals).toEqual([
      'Error: createBodyLayer needs a source of bodies: createBodyLayer({ source: worldSource(world) })',
      'Error: createTrailLayer needs a source of bodies: createTrailLayer({ source: worldSource(world) })',
      'Error: createLinkLayer needs a source of bodies: createLinkLayer({ source: worldSource(world) })',
      'Error: createContactLayer needs a world made by createPhysicsWorld: createContactLayer({ world })',
      'Error: createBoxLayer needs a world made by createPhysicsWorld: createBoxLayer({ world })',
    ]);
    expect(screen).toContain('openScreen(document.body)');
  });

  it('turns nothing in a layer without rotation, whatever another layer of the same bodies does', async () => {
    expect(await page.evaluate((b) => pixiLab.unturned(b), backend)).toBe(0);
  });

  it('opens a screen with the context that was asked for, and closes it once', async () => {
    expect(await page.evaluate(() => pixiLab.screen())).toEqual({ preserves: true, isGone: true });
  });

  it('keeps f64 positions precise 10⁹ m from zero', async () => {
    const seen = await page.evaluate((b) => pixiLab.disc(b, 'f64', 1e9), backend);
    expect(seen.area / discArea(40)).toBeCloseTo(1, 2);
    expect(seen.x).toBeCloseTo(6.3, 1);
  });

  it('interpolates position and, the shorter way round, angle', async () => {
    const seen = await page.evaluate((b) => pixiLab.interpolation(b, [0, 0.5, 1]), backend);
    for (const [i, alpha] of [0, 0.5, 1].entries()) {
      expect(seen.positions[i].x).toBeCloseTo(-30 + 60 * alpha, 0);
      expect(seen.positions[i].y).toBeCloseTo(-50 + 60 * alpha, 0);
      const turn = seen.marks[i] - (3 + alpha * (2 * Math.PI - 6));
      expect(Math.abs(Math.atan2(Math.sin(turn), Math.cos(turn)))).toBeLessThan(0.05);
    }
  });

  it('takes colour and radius from the body, else the default and the collider', async () => {
    const { areas, faded } = await page.evaluate((b) => pixiLab.styles(b), backend);
    expect(areas[0] / discArea(10)).toBeCloseTo(1, 1);
    expect(areas[1] / discArea(15)).toBeCloseTo(1, 1);
    expect(areas[2] / discArea(20)).toBeCloseTo(1, 1);
    expect(faded / areas[2]).toBeCloseTo(0.5, 2);
  });

  it.each([0, 0.4])(
    'darkens a rim of 2 pixels along the edge of a square, and over the mark of a disc, and none of a glow',
    async (angle) => {
      const seen = await page.evaluate(([b, a]) => pixiLab.rims(b, a), [backend, angle] as const);
      // 45 % of the light in the rim; a square with an inscribed disc would have a fifth less.
      expect(seen.square / (76 ** 2 + 0.45 * (80 ** 2 - 76 ** 2))).toBeCloseTo(1, 2);
      // 45 % of 64 of 255 all round.
      expect(Math.abs(seen.darkest - 29)).toBeLessThanOrEqual(1);
      expect(Math.abs(seen.brightest - 29)).toBeLessThanOrEqual(1);
      // The integral of (1 - r²)² over the disc: a glow has no edge.
      expect(seen.glow / (discArea(40) / 3)).toBeCloseTo(1, 2);
    },
  );

  it('draws the shape of each collider, turned by its angle', async () => {
    const seen = await page.evaluate((b) => pixiLab.colliders(b), backend);
    for (const { kind, area, expected, offX, offY } of seen) {
      // A segment of 80 m is drawn as a line of 1.5 pixels.
      expect(area / (kind === 'segment' ? 80 * 1.5 : expected)).toBeCloseTo(1, kind === 'segment' ? 1 : 2);
      expect(Math.hypot(offX, offY)).toBeLessThan(0.05);
    }
  });

  it.each([0, 2])(
    'places graphics and sprites in a container with y up as the world has it, turned by %d',
    async (angle) => {
      const seen = await page.evaluate(([b, a]) => pixiLab.worldContainer(b, a), [backend, angle] as const);
      // The centroid of the triangle is (40, 60)/3 from its corner.
      const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
      for (const { area, x, y } of seen) {
        expect(area / (0.5 * 40 * 60)).toBeCloseTo(1, 1);
        expect(x).toBeCloseTo(30 + (40 * cos - 60 * sin) / 3, 0);
        expect(y).toBeCloseTo(20 + (40 * sin + 60 * cos) / 3, 0);
      }
    },
  );

  it('draws contact points as dots, and their normals as lines', async () => {
    const { points, normals } = await page.evaluate((b) => pixiLab.contacts(b), backend);
    // Two dots of 9 pixels at a height of -20 m, and two lines of 40 m by 1.5 pixels upward, whose feet the dots hide.
    expect(points.area / (2 * discArea(4.5))).toBeCloseTo(1, 1);
    expect(points.x).toBeCloseTo(0, 1);
    expect(points.y).toBeCloseTo(-20, 0);
    expect(normals.area / (2 * 1.5 * 36)).toBeCloseTo(1, 1);
    expect(normals.y).toBeGreaterThan(-5);
  });

  it('draws a population with holes as it grows and shrinks', async () => {
    const counts = [10, 3000, 4096, 100, 0];
    const lights = await page.evaluate(([b, c]) => pixiLab.population(b, c), [backend, counts] as const);
    const [[one]] = lights;
    expect(one / 10 / Math.PI).toBeCloseTo(1, 0);
    for (const [i, count] of counts.entries()) {
      for (const seen of lights[i]) expect(seen).toBeCloseTo((count * one) / 10, 0);
    }
  });
});

describe.each<Backend>(['webgl', 'webgpu'])('trails and lines with %s', HANGS, (backend) => {
  useFreshPage();

  // 32 segments of a circle of radius 80 cut into 64, fading from full to nothing and tapering from 3 to 0.9 pixels.
  const halfTurn = Math.PI * 80 * (0.3 * 3 * 0.5 + (0.7 * 3) / 3);

  it.each([
    ['all bodies', {}],
    ['chosen bodies', { bodies: [1500, 7] }],
    ['far from zero', { far: 1e8 }],
  ])('draws the last half turn, %s', async (_, options) => {
    const seen = await page.evaluate(([b, o]) => pixiLab.trail(b, { ...o, steps: 81 }), [backend, options] as const);
    // 80 steps are a quarter past a full turn: the trail of body 7 lies to the right, that of the other to the left.
    for (const [i, side] of [1, -1].entries()) {
      expect(seen.lights[i].area / halfTurn).toBeGreaterThan(0.9);
      expect(seen.lights[i].area / halfTurn).toBeLessThan(1.1);
      expect(side * seen.lights[i].x).toBeGreaterThan(30);
    }
    expect(seen.cleared).toBe(0);
  });

  it('draws lines of the right area and colour, and links between moving bodies', async () => {
    const seen = await page.evaluate((b) => pixiLab.lines(b), backend);
    expect(seen.thick.area).toBeCloseTo(100 * 6 + discArea(3), -1);
    expect(seen.thick.y).toBeCloseTo(20, 1);
    expect(seen.colored[0]).toBeGreaterThan(550);
    expect(seen.colored[1]).toBeGreaterThan(1200);
    expect(seen.dots / 3000).toBeGreaterThan(0.8 * 3);
    expect(seen.linked[0].area).toBeCloseTo(81, -1);
    expect(seen.linked[0].y).toBeCloseTo(0, 1);
    expect(seen.linked[1].y).toBeCloseTo(30, 1);
    expect(seen.unlinked).toBe(0);
  });
});

describe.each<Backend>(['webgl', 'webgpu'])('the box of a layer with %s', HANGS, (backend) => {
  useFreshPage();

  it('holds what is drawn, so that filters and textures cut nothing off, and little more', async () => {
    const { seen, moved } = await page.evaluate((b) => pixiLab.boxes(b), backend);
    // Left, bottom, right and top of the drawn centres and ends, and how far they are drawn beyond these.
    const [sides, corner] = [[-30, -60, 50, 20], 11 * Math.SQRT2];
    const expected = [
      { at: [-30, -60, 50, 20], reach: [5, 5, corner, corner] },
      { at: sides, reach: [4, 4, 4, 4] },
      { at: [-40, 10, 70, 10], reach: [6, 6, 6, 6] },
      { at: [-30, -60, 50, 20], reach: [5, 5, 5, 5] },
    ];
    for (const [i, { lit, box, filtered, cached }] of seen.entries()) {
      const { at, reach } = expected[i];
      for (let side = 0; side < 4; side++)
        expect((box[side] - at[side]) * (side < 2 ? -1 : 1)).toBeCloseTo(reach[side], 3);
      expect(lit).toBeGreaterThan(50);
      // Soft edges are a little sharper there: the textures that pixi takes are larger than the picture in them.
      for (const seenThere of [filtered, cached]) expect(Math.abs(seenThere / lit - 1)).toBeLessThan(0.03);
    }
    expect(moved).toBeCloseTo(25, 3);
  });

  it('may be that of some bodies only, which lie above others whatever their ids are', async () => {
    const { below, above, gone } = await page.evaluate((b) => pixiLab.chosen(b), backend);
    const area = Math.PI * 10 ** 2;
    for (const [[red, green], isAbove] of [
      [below, false],
      [above, true],
      [gone, false],
    ] as const) {
      // The soft edge lets the lower disc shine through.
      expect(Math.abs((isAbove ? green : red) / area - 1)).toBeLessThan(0.03);
      expect((isAbove ? red : green) / area).toBeLessThan(0.1);
    }
  });

  it('keeps the widths of lines and rims in a texture of a container around the one under the camera', async () => {
    const { plain, cached, moved, plainMoved } = await page.evaluate((b) => pixiLab.cached(b), backend);
    expect(Math.abs(cached / plain - 1)).toBeLessThan(0.01);
    expect(moved).toBeCloseTo(plainMoved, 0);
  });
});

describe('bodies', () => {
  useFreshPage();

  it.each(['showShapes', 'showAll', 'showColliders'] as const)(
    'look the same in WebGL and WebGPU: %s',
    async (show) => {
      const seen = await page.evaluate((s) => pixiLab.backendsDiffer(s), show);
      expect(seen.lit).toBeGreaterThan(3000);
      expect(seen.beyondRounding).toBe(0);
    },
  );

  it('come back unchanged after the context was lost', async () => {
    const seen = await page.evaluate(() => pixiLab.contextLoss());
    expect(seen.lit).toBeGreaterThan(3000);
    expect(seen.differing).toBe(0);
  });

  it('are uploaded once per change, however many layers draw them', async () => {
    const seen = await page.evaluate(() => pixiLab.uploads());
    expect(seen.still).toBe(0);
    expect(seen.pose).toBe(6);
    expect(seen.style).toBe(4);
    expect(seen.afterDestroy).toBe(6);
  });
});
