export { type BodyDragging, type BodyDraggingOptions, listenToBodyDragging } from './body-dragging.ts';
export { type BodyMesh, createBodyMesh } from './body-mesh.ts';
export type { BodyMeshOptions } from './body-pass.ts';
export { type PickOptions, pickBody } from './body-picker.ts';
export { type BoxFrame, createBoxFrame } from './box-frame.ts';
export { createOrbitCamera, type OrbitCamera, type OrbitCameraOptions } from './orbit-camera.ts';
export { fitRendererToParent } from './renderer-size.ts';
export { createSegmentLines, type SegmentLines, type SegmentLinesOptions } from './segment-lines.ts';
export { createTrailLines, type TrailLines, type TrailLinesOptions } from './trail-lines.ts';
