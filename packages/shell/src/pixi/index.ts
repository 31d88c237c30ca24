/** Views drawn by pixi.js, apart from the shell itself, so that a page loads no renderer that it does not show. */
export { openPixiView, type Picture, type PixiViewOptions } from './pixi-view.ts';
