export { type BodyMesh, type BodyMeshOptions, createBodyMesh } from './body-mesh.ts';
export { type PickOptions, pickBody } from './body-picker.ts';
export { createOrbitCamera, type OrbitCamera, type OrbitCameraOptions } from './orbit-camera.ts';
export { fitRendererToParent } from './renderer-size.ts';
