/** What an example shows: plain records, which the page draws with pixi.js or three.js and which need no display. */

/** A point or a vector in the units of the world; `z` counts in three dimensions. */
export interface Point {
  readonly x: number;
  readonly y: number;
  readonly z?: number;
}

/** A value, or a function that returns its present state. */
export type Live<T> = T | (() => T);

/** A colour as 0xRRGGBB; the palette of `COLORS` is legible on the dark page. */
export type Color = number;

/** The region that is shown, in metres, or in the units of the axes of a graph. */
export interface ViewBox {
  readonly minX: number;
  readonly maxX: number;
  readonly minY: number;
  readonly maxY: number;
  /** In three dimensions; a view that leaves them out is as deep as it is wide or high, a box has no depth. */
  readonly minZ?: number;
  readonly maxZ?: number;
}

/** A straight line, such as a wall, a floor or the string of a pendulum. */
export interface Line {
  readonly from: Live<Point>;
  readonly to: Live<Point>;
  readonly color?: Color;
  /** CSS pixels; default 2. */
  readonly width?: number;
  /** Draws the line as a coil spring with this number of turns. */
  readonly coils?: number;
}

/** A filled region, such as water or ground. */
export interface Fill {
  /**
   * A box, a disc or a polygon; in three dimensions a box without width, height or depth, such as a wall, or a ball that
   * shines by itself, such as a sun. A disc or a polygon that moves is drawn over the bodies.
   */
  readonly shape: ViewBox | { readonly centre: Live<Point>; readonly radius: number } | Live<readonly Point[]>;
  readonly color: Color;
  /** 0 to 1; default 1. */
  readonly opacity?: number;
  /** Draws the region over the bodies, as water is. */
  readonly inFront?: boolean;
}

/** A curve of known points, such as an exact path. */
export interface Curve {
  readonly label?: string;
  readonly color?: Color;
  readonly points: readonly Point[];
  readonly dashed?: boolean;
  /** Marks the point where the curve should be now, by a ring of the radius of `markRadius`. */
  readonly now?: (time: number) => Point;
  /** Radius of the ring, m; default 5 CSS pixels. */
  readonly markRadius?: number;
}

/** An arrow, such as a velocity or a force. */
export interface Arrow {
  readonly label: string;
  readonly from: Live<Point>;
  readonly vector: () => Point;
  /** Metres drawn per unit of the vector; default 1. */
  readonly scale?: number;
  readonly color?: Color;
}

/** A dot that is no body of the world. */
export interface Dot {
  readonly at: Live<Point>;
  /** CSS pixels; default 6. */
  readonly radius?: number;
  readonly color?: Color;
}

/** A line of text. */
export interface Label {
  readonly at: Live<Point>;
  readonly text: Live<string>;
  readonly color?: Color;
}

/** The path that a body has taken. */
export interface Trail {
  readonly body: number;
  /** Points of the trail, one for each `interval` steps; default 600. */
  readonly length?: number;
  /** Default 1. */
  readonly interval?: number;
  readonly color?: Color;
}

/** The axes of a graph. */
export interface Axis {
  /** Name and unit, such as `t, s`. */
  readonly label: string;
  /** Distance of the lines of the grid; default: a round number. */
  readonly step?: number;
}

/** Where the camera is and at what it looks at a time, s. Between the keys of a path it goes along a smooth curve. */
export interface CameraKey {
  readonly time: number;
  readonly eye: Point;
  readonly target: Point;
}

/** Everything that an example shows. Bodies with a collider or a size are drawn by themselves, in their own colours. */
export interface Picture {
  readonly view: ViewBox;
  /** The y axis of the world points down, as in most drawing programs. */
  readonly yDown?: boolean;
  /**
   * The picture is a graph: `view` is in the units of these axes, which have scales of their own, and everything but
   * bodies is drawn in these units.
   */
  readonly graph?: { readonly x: Axis; readonly y: Axis };
  readonly fills?: readonly Fill[];
  readonly lines?: readonly Line[];
  /** Draws the springs of the world: as lines, or as coils of this number of turns. */
  readonly springs?: 'lines' | { readonly coils: number };
  readonly trails?: readonly Trail[];
  readonly curves?: readonly Curve[];
  readonly arrows?: readonly Arrow[];
  readonly dots?: readonly Dot[];
  readonly labels?: readonly Label[];
  /** In three dimensions: the direction from `target` to `eye` is that from which all of `view` is seen. */
  readonly camera?: { readonly eye: Point; readonly target: Point };
  /**
   * In three dimensions: a flight of the camera through these places, which begins with the run and which the reader ends by
   * taking the camera. Where motion is reduced, the view is that of `camera`.
   */
  readonly cameraPath?: readonly CameraKey[];
}

/** Colours that are legible on the dark page and differ for colour-blind people. */
export const COLORS = {
  blue: 0x6db7ff,
  orange: 0xffb347,
  green: 0x5fd6a2,
  red: 0xff7b72,
  yellow: 0xffe08a,
  violet: 0xb79cff,
  white: 0xe8ecfb,
  grey: 0x8f9bc0,
  water: 0x2f7fd0,
  ground: 0x4a5578,
} as const satisfies Record<string, Color>;

/** Points of a curve at `count` + 1 equal steps of its parameter. */
export function pointsOf(curve: (at: number) => Point, from: number, to: number, count = 200): Point[] {
  return Array.from({ length: count + 1 }, (_, i) => curve(from + ((to - from) * i) / count));
}

/** The present state of a live value. */
export function now<T extends object | string>(value: Live<T>): T {
  return typeof value === 'function' ? (value as () => T)() : value;
}
