import type { BodySource, PosePair } from '@principia/render-core';
import { PoseColumns } from './pose-columns.ts';
import { turnUniforms } from './shaders/body-pull.ts';

/** Present and previous rotations as textures: angles in 2D, quaternions in 3D. */
export function createTurnTextures(source: BodySource, pair: PosePair): PoseColumns {
  const { angle, previousAngle, orientation: q, previousOrientation: before } = source;
  const names = turnUniforms[source.dimensions];
  if (source.dimensions === 2) return new PoseColumns(source, pair, [angle], [previousAngle], names);
  const previous = [before.x, before.y, before.z, before.w];
  return new PoseColumns(source, pair, [q.x, q.y, q.z, q.w], previous, names);
}
