import { checkCount } from './buffer-capacity.ts';
import { writeColor } from './color.ts';

/** Options of a layer of lines. */
export interface LineStyle {
  /** CSS pixels at any zoom; default 2. */
  thickness?: number;
  /** Default colour of lines, as 0xRRGGBB; default 0xc8d0d8. */
  color?: number;
  /** Opacity of lines in the default colour; default 1. */
  opacity?: number;
  /** `add` lets overlapping lines brighten each other; default `normal`. */
  blendMode?: 'normal' | 'add';
  /** Pixels of the layer's own coordinates per metre; default 1, which is what `applyCamera` expects. */
  pixelsPerMetre?: number;
}

/** Default thickness, CSS pixels. */
const THICKNESS = 2;

/** An object with a program's uniforms. */
interface UniformTarget {
  readonly uniforms: Record<string, number | Float32Array>;
}

/** Sets the uniforms that segments and links share. */
export function applyLineStyle(mesh: UniformTarget, style: LineStyle): void {
  const { thickness = THICKNESS, color = 0xc8d0d8, opacity = 1 } = style;
  checkThickness(thickness);
  const rgba = new Float32Array(4);
  writeColor(rgba, color, opacity);
  mesh.uniforms.uLineColor = rgba;
  mesh.uniforms.uThickness = thickness;
}

/** How far a line of a thickness in CSS pixels reaches to its sides, metres, with its soft edge. @param pixel metres */
export function lineReach(thickness: number | undefined, pixel: number): number {
  return (0.5 * Math.max(thickness ?? THICKNESS, 1) + 1) * pixel;
}

/**
 * The number of lines in an array of `each` numbers a line.
 *
 * @param count number of lines that are wanted; default: all in the array
 * @throws Error when it is not a whole number from zero, or the array ends before or within a line
 */
export function lineCount(name: string, values: ArrayLike<number>, each: number, count?: number): number {
  if (count === undefined) {
    if (values.length % each === 0) return values.length / each;
    throw new Error(`${name} must hold ${each} numbers for each line, got ${values.length} in all`);
  }
  checkCount(count);
  checkLength(name, values, each * count);
  return count;
}

/** @throws Error when an array has fewer than `needed` numbers */
export function checkLength(name: string, values: ArrayLike<number>, needed: number): void {
  if (values.length >= needed) return;
  throw new Error(`${name} must hold at least ${needed} numbers for this number of lines, got ${values.length}`);
}

/** @throws Error when a line's thickness, CSS pixels, is not a positive number */
export function checkThickness(thickness: number): void {
  if (!(thickness > 0 && Number.isFinite(thickness))) {
    throw new Error(`thickness must be a positive number of pixels, got ${thickness}`);
  }
}
