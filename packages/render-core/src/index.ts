export { checkAlpha, checkOptions, type OptionNames, sourceOf, worldOf } from './arguments.ts';
export { type BodySource, OUTLINE_TEXELS, type Outlines, type RealColumn } from './body-source.ts';
export {
  type Bounds2,
  type Camera2D,
  fit,
  follow,
  panBy,
  toScreen,
  toWorld,
  type Vector2,
  type ViewportSize,
  type ZoomLimits,
  zoomAt,
} from './camera-2d.ts';
export type { BodyChoice } from './chosen-bodies.ts';
export { ColumnUpload, TEXTURE_WIDTH, textureRows } from './column-upload.ts';
export { LivingBodies } from './living-bodies.ts';
export { listenToPointers, type PointerControl, type PointerOptions } from './pointer.ts';
export { placeInPicture, placeOnCanvas } from './pointer-place.ts';
export { PosePair, UploadedPoses } from './pose-pair.ts';
export { ReleaseVelocity } from './release-velocity.ts';
export { SHAPES, type ShapeKind, type ShapeName } from './shapes.ts';
export { TrailHistory, type TrailOptions } from './trails.ts';
export { sizeToFill, type Viewport, type ViewportOptions, watchViewport } from './viewport.ts';
export { type WorldSourceOptions, worldSource } from './world-source.ts';
