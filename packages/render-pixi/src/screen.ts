// Layers are meshes; of pixi's other parts each page names those that it uses.
import 'pixi.js/mesh';
import { sizeToFill } from '@principia/render-core';
import {
  type AutoDetectOptions,
  autoDetectRenderer,
  Container,
  type Renderer,
  type RenderOptions,
  VERSION,
  type WebGLOptions,
  WebGLRenderer,
} from 'pixi.js';
import { requirePixi } from './pixi-version.ts';

/** A canvas that pixi draws on. */
export interface Screen {
  readonly renderer: Renderer;
  readonly canvas: HTMLCanvasElement;
  /** What is drawn. */
  readonly stage: Container;
  /** Draws the stage; makes no objects. */
  render(): void;
  /** Frees everything on the stage and takes the canvas away. */
  destroy(): void;
}

/** What pixi's renderers take. */
export type ScreenOptions = Partial<WebGLOptions & AutoDetectOptions>;

/**
 * Opens a canvas in `parent`, as large as it, with WebGL 2, or with WebGPU where there is none; follow `parent` with
 * `watchViewport`. An `Application` of pixi's also makes a canvas, but tries WebGL on one that it throws away, makes
 * another that it has to enlarge, and loads pixi's events, filters and other parts before the first picture: here
 * `pixi.js/graphics` and the like are to be imported by who uses them.
 *
 * @throws Error when the browser has neither, or pixi.js is too old
 */
export async function openScreen(parent: HTMLElement, options: ScreenOptions = {}): Promise<Screen> {
  requirePixi(VERSION);
  const { width, height, resolution } = sizeToFill(parent);
  const size = { width: Math.max(1, width), height: Math.max(1, height), resolution };
  const wanted = { autoDensity: true, ...size, ...options, skipExtensionImports: true };
  const renderer = (await openWebGL(wanted)) ?? (await autoDetectRenderer({ ...wanted, preference: ['webgpu'] }));
  parent.append(renderer.canvas);
  const stage = new Container({ eventMode: 'none' });
  const order: { -readonly [Key in keyof RenderOptions]: RenderOptions[Key] | undefined } = { container: stage };
  return {
    renderer,
    canvas: renderer.canvas,
    stage,
    render() {
      // Pixi fills these in, and would take them for wishes the next time.
      order.transform = undefined;
      order.clearColor = undefined;
      renderer.render(order as RenderOptions);
    },
    destroy() {
      stage.destroy({ children: true });
      renderer.destroy({ removeView: true, releaseGlobalResources: false });
    },
  };
}

interface Size {
  readonly width: number;
  readonly height: number;
  readonly resolution: number;
}

async function openWebGL(options: ScreenOptions & Size): Promise<Renderer | undefined> {
  const canvas = document.createElement('canvas');
  // In this order: a context whose canvas changes its size makes all its buffers anew.
  canvas.width = Math.round(options.width * options.resolution);
  canvas.height = Math.round(options.height * options.resolution);
  const context = canvas.getContext('webgl2', {
    alpha: (options.backgroundAlpha ?? 1) < 1,
    antialias: options.antialias ?? false,
    powerPreference: options.powerPreference ?? 'default',
    premultipliedAlpha: true,
    stencil: true,
  });
  if (context === null) return undefined;
  const renderer = new WebGLRenderer();
  await renderer.init({ ...options, canvas, context });
  return renderer as Renderer;
}
