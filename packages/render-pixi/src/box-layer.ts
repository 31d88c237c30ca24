import { type BodyBoxes, bodyBoxes, type PhysicsWorld } from '@principia/physics';
import { checkOptions, type OptionNames, worldOf } from '@principia/render-core';
import type { Container } from 'pixi.js';
import { groupColor } from './group-colors.ts';
import { createSegmentLayer } from './segment-layer.ts';

/** Options of a box layer. */
export interface BoxLayerOptions {
  /** A world with the preset `rigidBodies`. */
  world: PhysicsWorld;
  /** Pixels of the layer's own coordinates per metre; default 1, which is what `applyCamera` expects. */
  pixelsPerMetre?: number;
  /** Width of the lines, CSS pixels; default 1. */
  thickness?: number;
  /** Colour of boxes of bodies that are awake, RGBA bytes in memory order; default 0xff50c0ff. */
  awakeColor?: number;
  /** Colour of boxes of bodies that sleep, RGBA bytes in memory order; default 0xffa08070. */
  asleepColor?: number;
  /** Whether boxes of bodies that touch or are joined have one colour, which then tells nothing of sleep; default false. */
  byIsland?: boolean;
}

/** The boxes of the broad phase, for looking into a simulation. */
export interface BoxLayer {
  /** Add it anywhere, as that of a body layer. */
  readonly container: Container;
  /** Draws the boxes that the last step left; call it once a frame before rendering. */
  update(): void;
  /** Frees the layer's resources and removes it from its parent. */
  destroy(): void;
}

/** Sides of a box. */
const SIDES = 4;

/** The colour of an island: bits of its id by Fibonacci hashing, so that equal piles beside each other differ. */
function colorOf(island: number): number {
  return groupColor(Math.imul(island, 0x9e3779b1) >>> 20);
}

const OPTION_NAMES: OptionNames<BoxLayerOptions> = {
  world: true,
  pixelsPerMetre: true,
  thickness: true,
  awakeColor: true,
  asleepColor: true,
  byIsland: true,
};

/**
 * Creates a layer that shows the boxes of rigid bodies, and which sleep.
 * @throws Error when there is no world, or an option is out of range or does not exist
 */
export function createBoxLayer(options: BoxLayerOptions): BoxLayer {
  const world = worldOf(options, 'createBoxLayer');
  checkOptions(options, OPTION_NAMES, 'createBoxLayer');
  const { pixelsPerMetre = 1, thickness = 1, byIsland = false } = options;
  const { awakeColor = 0xff50c0ff, asleepColor = 0xffa08070 } = options;
  const lines = createSegmentLayer({ pixelsPerMetre, thickness });
  const ends: number[] = [];
  const colors: number[] = [];
  let list: BodyBoxes | undefined;
  return {
    container: lines.container,
    update() {
      list = bodyBoxes(world, list);
      for (let i = 0; i < list.count; i++) {
        writeSides(ends, i, list);
        const island = byIsland ? list.island[i] : 0;
        const bySleep = list.asleep[i] ? asleepColor : awakeColor;
        const color = island === 0 ? bySleep : colorOf(island);
        for (let side = 0; side < SIDES; side++) colors[SIDES * i + side] = color;
      }
      lines.set(ends, SIDES * list.count, colors);
    },
    destroy: lines.destroy,
  };
}

function writeSides(ends: number[], i: number, { minX, minY, maxX, maxY }: BodyBoxes): void {
  const [left, bottom, right, top] = [minX[i], minY[i], maxX[i], maxY[i]];
  const at = 4 * SIDES * i;
  writeLine(ends, at, left, bottom, right, bottom);
  writeLine(ends, at + 4, right, bottom, right, top);
  writeLine(ends, at + 8, right, top, left, top);
  writeLine(ends, at + 12, left, top, left, bottom);
}

function writeLine(ends: number[], at: number, x1: number, y1: number, x2: number, y2: number): void {
  ends[at] = x1;
  ends[at + 1] = y1;
  ends[at + 2] = x2;
  ends[at + 3] = y2;
}
