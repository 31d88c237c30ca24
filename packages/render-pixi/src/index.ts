export { type BodyLayer, type BodyLayerOptions, createBodyLayer } from './body-layer.ts';
export { applyCamera, type CameraTarget } from './camera.ts';
export { type ContactLayer, type ContactLayerOptions, createContactLayer } from './contact-layer.ts';
export type { LineStyle } from './line-style.ts';
export { createLinkLayer, type LinkLayer, type LinkLayerOptions } from './link-layer.ts';
export { openScreen, type Screen, type ScreenOptions } from './screen.ts';
export { createSegmentLayer, type SegmentLayer } from './segment-layer.ts';
export { createTrailLayer, type TrailLayer, type TrailLayerOptions } from './trail-layer.ts';
