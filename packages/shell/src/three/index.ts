/** Views drawn by three.js. They are a separate entry point so that a page loads no renderer that it does not show. */
export type { CameraKey } from './camera-path.ts';
export {
  type BoxBounds,
  openThreeView,
  type ThreePicture,
  type ThreeView,
  type ThreeViewOptions,
} from './three-view.ts';
