import type { BodySource } from '@principia/render-core';
import { createBodyLayer } from '@principia/render-pixi';

/** The picture of a game of a test page: its bodies, and nothing else. */
export function paintBodies(_sim: unknown, source: BodySource) {
  const { container, update, destroy } = createBodyLayer({ source });
  return { container, update, destroy };
}
