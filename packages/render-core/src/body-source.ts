/** A column of real numbers as the world stores it: `Float32Array` in an f32 world, `Float64Array` in an f64 one. */
export type RealColumn = Float32Array | Float64Array;

/** Outlines of colliders, for shaders. */
export interface Outlines {
  /**
   * `OUTLINE_TEXELS` numbers for each outline: number of vertices, rounding, greatest distance from the origin, half of
   * the least width, then x and y of each vertex, metres. Its length is a multiple of 1024; the first outline is unused.
   */
  readonly texels: Float32Array;
  /** Numbers in use, from the start. */
  readonly used: number;
  /** Changes when they may have changed. */
  readonly version: number;
}

/** Numbers that an outline takes: four and up to eight vertices. */
export const OUTLINE_TEXELS = 20;

/**
 * The data that a renderer reads from a world: columns indexed by entity id, a dense list of the ids to draw, and
 * version counters that say when a column must be uploaded again. Columns have `rows` values, a multiple of 1024, so a
 * column is a texture 1024 texels wide.
 */
export interface BodySource {
  readonly dimensions: 2 | 3;
  /** Length of every column; a multiple of 1024. */
  readonly rows: number;
  /** Centre of a body now and one step ago, metres. `z` stays zero in a 2D world. */
  readonly position: { readonly x: RealColumn; readonly y: RealColumn; readonly z: RealColumn };
  readonly previousPosition: { readonly x: RealColumn; readonly y: RealColumn; readonly z: RealColumn };
  /** 2D: angle in radians, anticlockwise, now and one step ago. */
  readonly angle: RealColumn;
  readonly previousAngle: RealColumn;
  /** 3D: unit quaternion now and one step ago; (0, 0, 0, 0) means "not rotated". */
  readonly orientation: {
    readonly x: RealColumn;
    readonly y: RealColumn;
    readonly z: RealColumn;
    readonly w: RealColumn;
  };
  readonly previousOrientation: {
    readonly x: RealColumn;
    readonly y: RealColumn;
    readonly z: RealColumn;
    readonly w: RealColumn;
  };
  /** Radius of the collider, metres; drawn if `size` is zero. */
  readonly radius: RealColumn;
  /** Drawn radius, metres; zero means the radius of the collider. Where both are zero, the body is not drawn. */
  readonly size: RealColumn;
  /** Colour as RGBA bytes in memory order (`0xAABBGGRR` as a little-endian number); zero means the renderer's default. */
  readonly color: Uint32Array;
  /** Shape kind, see `SHAPES`. */
  readonly shape: Uint32Array;
  /** Number of the outline of the collider in `outlines`, 0 for a disc or ball. Default all 0. */
  readonly outline?: Uint32Array;
  /** The outlines that colliders have. Default none. */
  readonly outlines?: Outlines;
  /**
   * The ids to draw, ascending: `ids[0 … count)`. The array may be replaced; read it again when `membership` changed.
   */
  readonly ids: Uint32Array;
  readonly count: number;
  /** Highest id in `ids` (zero when empty): rows above it need no upload. */
  readonly lastId: number;
  /**
   * By id, a number that changes when its body is removed, as the next one has the same id; `membership` counts that too.
   * Default none: a body that took an id between two pictures is taken for the former one.
   */
  readonly generations?: Uint32Array;
  readonly versions: {
    /** Incremented when any position, angle or orientation may have changed. */
    readonly pose: number;
    /** Incremented when any radius, size, colour or shape may have changed. */
    readonly style: number;
    /** Incremented when `ids` changed. */
    readonly membership: number;
    /**
     * Number of steps. If `steps` and `pose` grew by one and `membership` did not change, the new previous poses equal
     * the old present ones and are not uploaded again. Default none: both are always uploaded.
     */
    readonly steps?: number;
    /** Number of times that an earlier state came back, at which trails begin anew. Default none: they go on. */
    readonly restored?: number;
  };
}
