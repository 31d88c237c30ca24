/** A point or displacement; metres in the world, CSS pixels on the screen. */
export interface Vector2 {
  x: number;
  y: number;
}

/** Size of the area drawn to, CSS pixels. */
export interface ViewportSize {
  readonly width: number;
  readonly height: number;
}

/** Rectangle in the world, metres. */
export interface Bounds2 {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
}

/**
 * The position and scale of a 2D view. The world's y axis points up, the screen's y axis points down from the top-left
 * corner.
 */
export interface Camera2D {
  /** World point at the centre of the viewport, metres. */
  x: number;
  y: number;
  /** CSS pixels per metre. */
  pixelsPerMetre: number;
}

/** Limits of `zoomAt`, pixels per metre. */
export interface ZoomLimits {
  readonly min: number;
  readonly max: number;
}

/** Screen to world: from CSS pixels to metres, written into `out`, which is also returned. */
export function toWorld(
  camera: Camera2D,
  viewport: ViewportSize,
  screenX: number,
  screenY: number,
  out: Vector2,
): Vector2 {
  out.x = camera.x + (screenX - viewport.width / 2) / camera.pixelsPerMetre;
  out.y = camera.y - (screenY - viewport.height / 2) / camera.pixelsPerMetre;
  return out;
}

/** World to screen: from metres to CSS pixels, written into `out`, which is also returned. */
export function toScreen(camera: Camera2D, viewport: ViewportSize, x: number, y: number, out: Vector2): Vector2 {
  out.x = viewport.width / 2 + (x - camera.x) * camera.pixelsPerMetre;
  out.y = viewport.height / 2 - (y - camera.y) * camera.pixelsPerMetre;
  return out;
}

/** Moves the view by (`dx`, `dy`) CSS pixels, so that the world follows the pointer. */
export function panBy(camera: Camera2D, dx: number, dy: number): void {
  camera.x -= dx / camera.pixelsPerMetre;
  camera.y += dy / camera.pixelsPerMetre;
}

/**
 * Scales the view by `factor` (above one is closer) and keeps the world point under the given screen point in place.
 *
 * @throws Error when `factor` is not a positive finite number
 */
export function zoomAt(
  camera: Camera2D,
  viewport: ViewportSize,
  screenX: number,
  screenY: number,
  factor: number,
  limits?: ZoomLimits,
): void {
  if (!(factor > 0 && Number.isFinite(factor))) throw new Error(`zoom factor must be a positive number, got ${factor}`);
  const before = camera.pixelsPerMetre;
  let after = before * factor;
  if (limits !== undefined) after = Math.min(limits.max, Math.max(limits.min, after));
  const metres = 1 / before - 1 / after;
  camera.x += (screenX - viewport.width / 2) * metres;
  camera.y -= (screenY - viewport.height / 2) * metres;
  camera.pixelsPerMetre = after;
}

/**
 * Centres `bounds` in the viewport with a margin of `margin` CSS pixels on every side, 0 by default. Bounds without a width are
 * fitted by their height, and the reverse. The scale does not change if they are a point, or if the viewport has zero width or
 * height.
 */
export function fit(camera: Camera2D, bounds: Bounds2, viewport: ViewportSize, margin = 0): void {
  camera.x = (bounds.minX + bounds.maxX) / 2;
  camera.y = (bounds.minY + bounds.maxY) / 2;
  const width = bounds.maxX - bounds.minX;
  const height = bounds.maxY - bounds.minY;
  const scale = Math.min(
    width > 0 ? Math.max(1, viewport.width - 2 * margin) / width : Number.POSITIVE_INFINITY,
    height > 0 ? Math.max(1, viewport.height - 2 * margin) / height : Number.POSITIVE_INFINITY,
  );
  if (viewport.width > 0 && viewport.height > 0 && Number.isFinite(scale)) camera.pixelsPerMetre = scale;
}

/**
 * Moves the camera towards a target as a critically damped spring: it never overshoots a target at rest, and the result
 * does not depend on the frame rate.
 *
 * @param velocity the camera's velocity, metres per second: state kept by the caller, starts at zero
 * @param smoothTime time constant 1/ω, seconds; 0.15 is brisk, zero jumps to the target
 * @param dt render time since the last call, seconds
 */
export function follow(
  camera: Camera2D,
  velocity: Vector2,
  targetX: number,
  targetY: number,
  smoothTime: number,
  dt: number,
): void {
  if (!(smoothTime > 0)) {
    camera.x = targetX;
    camera.y = targetY;
    velocity.x = 0;
    velocity.y = 0;
    return;
  }
  const omega = 1 / smoothTime;
  const decay = Math.exp(-omega * dt);
  const offsetX = camera.x - targetX;
  const offsetY = camera.y - targetY;
  const rateX = velocity.x + omega * offsetX;
  const rateY = velocity.y + omega * offsetY;
  camera.x = targetX + (offsetX + rateX * dt) * decay;
  camera.y = targetY + (offsetY + rateY * dt) * decay;
  velocity.x = (velocity.x - omega * rateX * dt) * decay;
  velocity.y = (velocity.y - omega * rateY * dt) * decay;
}
