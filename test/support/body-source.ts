import type { BodySource, RealColumn } from '../../packages/render-core/src/body-source.ts';

type Writable<T> = { -readonly [K in keyof T]: T[K] };

/** A test double of a world: a `BodySource` whose columns a test fills. */
export interface TestBodySource extends Omit<Writable<BodySource>, 'versions'> {
  versions: Writable<BodySource['versions']>;
  /** Replaces the list of ids to draw and increments every version. */
  show(ids: ArrayLike<number>): void;
}

/** Creates an empty source with `rows` rows (a multiple of 1024) of the given precision. */
export function createTestBodySource(
  rows: number,
  dimensions: 2 | 3 = 2,
  precision: 'f32' | 'f64' = 'f32',
): TestBodySource {
  const real = (): RealColumn => (precision === 'f32' ? new Float32Array(rows) : new Float64Array(rows));
  const vector = () => ({ x: real(), y: real(), z: real() });
  const quaternion = () => ({ x: real(), y: real(), z: real(), w: real() });
  return {
    dimensions,
    rows,
    position: vector(),
    previousPosition: vector(),
    angle: real(),
    previousAngle: real(),
    orientation: quaternion(),
    previousOrientation: quaternion(),
    radius: real(),
    size: real(),
    color: new Uint32Array(rows),
    shape: new Uint32Array(rows),
    ids: new Uint32Array(rows),
    count: 0,
    lastId: 0,
    versions: { pose: 1, style: 1, membership: 1 },
    show(ids) {
      this.ids = new Uint32Array(rows);
      for (let i = 0; i < ids.length; i++) this.ids[i] = ids[i];
      this.count = ids.length;
      this.lastId = ids.length === 0 ? 0 : ids[ids.length - 1];
      this.versions.pose++;
      this.versions.style++;
      this.versions.membership++;
    },
  };
}
