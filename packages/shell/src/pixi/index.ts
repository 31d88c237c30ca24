/** Views drawn by pixi.js. They are a separate entry point so that a page loads no renderer that it does not show. */
export { openPixiView, type Picture, type PixiView, type PixiViewOptions } from './pixi-view.ts';
