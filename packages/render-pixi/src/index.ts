export { type BodyLayer, type BodyLayerOptions, createBodyLayer } from './body-layer.ts';
export { applyCamera, type CameraTarget } from './camera.ts';
