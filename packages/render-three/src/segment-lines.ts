import { checkOptions, type OptionNames, TEXTURE_WIDTH } from '@principia/render-core';
import type { ColorRepresentation, Object3D } from 'three';
import { colorBytes } from './body-color.ts';
import { ColumnTexture } from './column-texture.ts';
import { createWideLineMesh } from './wide-line-mesh.ts';

/** Options of `createSegmentLines`. */
export interface SegmentLinesOptions {
  /** Colour of segments that are added without one; default a light grey, 0xc0c8d4. */
  color?: ColorRepresentation;
  /** Width in CSS pixels; default 1.5. */
  width?: number;
}

/** A list of straight lines that may change every frame: walls, springs, forces. */
export interface SegmentLines {
  /** Add it to the scene. */
  readonly object: Object3D;
  /** Number of segments. */
  readonly count: number;
  /** Removes all segments; the memory is kept. */
  clear(): void;
  /**
   * Adds a segment from `a` to `b`, metres. No garbage, except when the list grows.
   *
   * @param color RGBA bytes in memory order (`0xAABBGGRR`) at `a`; left out, the default colour
   * @param colorB the same at `b`; left out, `color`
   */
  add(ax: number, ay: number, az: number, bx: number, by: number, bz: number, color?: number, colorB?: number): void;
  /** Frees the GPU's memory; remove `object` from the scene yourself. */
  destroy(): void;
}

/** Two texels per segment: the coordinates of an end as float bits, and its colour. */
const segmentEnds = /* glsl */ `
uniform highp usampler2D segments;
const float endReach = 0.25; // the corners of a wall then have no notch

uvec4 endOf(int i) { return texelFetch(segments, ivec2(i % ${TEXTURE_WIDTH}, i / ${TEXTURE_WIDTH}), 0); }

bool segmentEnds(int i, out vec3 a, out vec3 b, out vec4 colorA, out vec4 colorB) {
  uvec4 endA = endOf(2 * i);
  uvec4 endB = endOf(2 * i + 1);
  a = uintBitsToFloat(endA.xyz);
  b = uintBitsToFloat(endB.xyz);
  colorA = lineColor(endA.w);
  colorB = lineColor(endB.w);
  return true;
}
`;

/** Lanes of a texel, and texels of a segment. */
const LANES = 4;
const ENDS = 2;

const OPTION_NAMES: OptionNames<SegmentLinesOptions> = { color: true, width: true };

/** Creates an empty list of lines. @throws Error when `width` is not above 0, or an option does not exist */
export function createSegmentLines(options: SegmentLinesOptions = {}): SegmentLines {
  checkOptions(options, OPTION_NAMES, 'createSegmentLines');
  const defaultColor = colorBytes(options.color ?? 0xc0c8d4);
  const texture = new ColumnTexture('uint4');
  let bits = new Uint32Array(TEXTURE_WIDTH * LANES);
  let numbers = new Float32Array(bits.buffer);
  let count = 0;
  let changed = false;
  const uniforms = { segments: { value: texture } };
  const line = createWideLineMesh(segmentEnds, uniforms, options.width ?? 1.5, (renderer) => {
    if (changed) {
      changed = false;
      texture.upload(bits, count * ENDS);
      line.setCount(count);
    }
    texture.send(renderer);
  });
  const grow = () => {
    const larger = new Uint32Array(bits.length * 2);
    larger.set(bits);
    bits = larger;
    numbers = new Float32Array(bits.buffer);
  };
  const writeEnd = (at: number, x: number, y: number, z: number, color: number) => {
    numbers[at] = x;
    numbers[at + 1] = y;
    numbers[at + 2] = z;
    bits[at + 3] = color;
  };
  return {
    object: line.mesh,
    get count() {
      return count;
    },
    clear() {
      count = 0;
      changed = true;
    },
    add(ax, ay, az, bx, by, bz, color = defaultColor, colorB = color) {
      const at = count * ENDS * LANES;
      if (at === bits.length) grow();
      writeEnd(at, ax, ay, az, color);
      writeEnd(at + LANES, bx, by, bz, colorB);
      count++;
      changed = true;
    },
    destroy() {
      line.destroy();
      texture.dispose();
    },
  };
}
