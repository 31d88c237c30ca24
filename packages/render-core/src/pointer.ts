import {
  type Camera2D,
  panBy,
  toWorld,
  type Vector2,
  type ViewportSize,
  type ZoomLimits,
  zoomAt,
} from './camera-2d.ts';
import { placeInPicture } from './pointer-place.ts';
import { ReleaseVelocity } from './release-velocity.ts';

/** Handlers of pointer input on a canvas. Coordinates are world metres, velocities metres per second. */
export interface PointerOptions {
  /** The camera of the picture, which panning and zooming change. */
  camera: Camera2D;
  /**
   * Size of the picture as `applyCamera` gets it, such as `app.screen`; read at each event. Give it where style sheets show the
   * picture in another size than it is drawn for. Default the size of the canvas on the page, before any `transform`.
   */
  viewport?: ViewportSize;
  /** Returns the body under a world point, or 0 for none. If omitted, nothing can be grabbed. */
  pick?(x: number, y: number): number;
  /** A pointer went down on body `id`. */
  onGrab?(id: number, x: number, y: number, pointerId: number): void;
  /** A pointer that drags `id` moved. */
  onDrag?(id: number, x: number, y: number, pointerId: number): void;
  /** A pointer released `id`; (`vx`, `vy`) is its velocity, for throwing. */
  onRelease?(id: number, x: number, y: number, vx: number, vy: number, pointerId: number): void;
  /** The primary button or a finger went down on empty space. Return true to keep the finger from panning and pinching. */
  onPress?(x: number, y: number, pointerId: number): boolean;
  /** A pointer moved while no button is down. */
  onHover?(x: number, y: number): void;
  /** Returns true while the primary button pans too, as while the space bar is held; it then grabs nothing. */
  primaryPans?(): boolean;
  /** The camera was moved or scaled by pan, wheel or pinch. */
  onNavigate?(): void;
  /** False disables panning and zooming; default true. */
  navigate?: boolean;
  /** Limits of the scale, pixels per metre. Default none. */
  zoomLimits?: ZoomLimits;
}

/** A canvas that listens to pointers until `destroy()`. */
export interface PointerControl {
  /** Releases at rest what is dragged, and stops listening. */
  destroy(): void;
}

interface Pointer {
  /** The dragged body, 0 for none. */
  body: number;
  /** Whether the pointer is down on empty space, so that two of them pan and pinch. */
  navigates: boolean;
  /** Whether the pointer pans the view alone. */
  pans: boolean;
  x: number;
  y: number;
  readonly velocity: ReleaseVelocity;
}

/** Scale change per wheel pixel: one notch of 100 pixels zooms by a factor of about 1.16. */
const WHEEL_RATE = 0.0015;

/** CSS pixels per wheel "line". */
const WHEEL_LINE = 16;

/**
 * Listens to mouse, pen and touch on a canvas. A pointer pressed on a body grabs it. The right or middle button pans, and
 * so do two fingers, which also pinch; the wheel zooms about the pointer. One finger or the primary button beside a body
 * does nothing, so that a player who misses a body does not lose the view. Several pointers work at once.
 *
 * Sets `touch-action: none` on the canvas, so that the browser does not scroll the page, and restores it on
 * `destroy()`.
 */
export function listenToPointers(canvas: HTMLCanvasElement, options: PointerOptions): PointerControl {
  const listener = new PointerListener(canvas, options);
  const touchAction = canvas.style.touchAction;
  canvas.style.touchAction = 'none';
  const handlers = [
    ['pointerdown', listener.down],
    ['pointermove', listener.move],
    ['pointerup', listener.up],
    ['pointercancel', listener.up],
  ] as const;
  for (const [type, handler] of handlers) canvas.addEventListener(type, handler);
  canvas.addEventListener('wheel', listener.wheel, { passive: false });
  canvas.addEventListener('contextmenu', listener.menu);
  return {
    destroy() {
      for (const [type, handler] of handlers) canvas.removeEventListener(type, handler);
      canvas.removeEventListener('wheel', listener.wheel);
      canvas.removeEventListener('contextmenu', listener.menu);
      canvas.style.touchAction = touchAction;
      listener.releaseAll();
    },
  };
}

class PointerListener {
  readonly #pointers = new Map<number, Pointer>();
  readonly #screen: Vector2 = { x: 0, y: 0 };
  readonly #world: Vector2 = { x: 0, y: 0 };
  readonly #size = { width: 0, height: 0 };

  readonly canvas: HTMLCanvasElement;
  readonly options: PointerOptions;

  constructor(canvas: HTMLCanvasElement, options: PointerOptions) {
    this.canvas = canvas;
    this.options = options;
  }

  readonly down = (event: PointerEvent): void => {
    if (event.pointerType === 'mouse' && event.button > 2) return;
    this.canvas.setPointerCapture(event.pointerId);
    const world = this.#locate(event);
    const { pick, onGrab, onPress, primaryPans, navigate = true } = this.options;
    const isPrimary = event.button === 0 && primaryPans?.() !== true;
    const body = isPrimary ? (pick?.(world.x, world.y) ?? 0) : 0;
    const taken = body === 0 && isPrimary && onPress?.(world.x, world.y, event.pointerId) === true;
    const velocity = new ReleaseVelocity();
    velocity.add(event.timeStamp / 1000, world.x, world.y);
    const navigates = body === 0 && !taken && navigate;
    const pans = navigates && !isPrimary;
    this.#pointers.set(event.pointerId, { body, navigates, pans, x: this.#screen.x, y: this.#screen.y, velocity });
    if (body !== 0) onGrab?.(body, world.x, world.y, event.pointerId);
  };

  readonly move = (event: PointerEvent): void => {
    const world = this.#locate(event);
    const pointer = this.#pointers.get(event.pointerId);
    if (pointer === undefined) {
      this.options.onHover?.(world.x, world.y);
    } else if (pointer.body !== 0) {
      pointer.velocity.add(event.timeStamp / 1000, world.x, world.y);
      this.options.onDrag?.(pointer.body, world.x, world.y, event.pointerId);
    } else if (pointer.navigates) {
      this.#navigate(pointer, event.pointerId);
    }
    if (pointer !== undefined) {
      pointer.x = this.#screen.x;
      pointer.y = this.#screen.y;
    }
  };

  readonly up = (event: PointerEvent): void => {
    const pointer = this.#pointers.get(event.pointerId);
    if (pointer === undefined) return;
    this.#pointers.delete(event.pointerId);
    if (pointer.body === 0) return;
    const world = this.#locate(event);
    pointer.velocity.estimate(event.timeStamp / 1000);
    const { x, y } = pointer.velocity;
    this.options.onRelease?.(pointer.body, world.x, world.y, x, y, event.pointerId);
  };

  readonly wheel = (event: WheelEvent): void => {
    if (this.options.navigate === false) return;
    event.preventDefault();
    this.#locate(event);
    const pixels = event.deltaMode === 0 ? event.deltaY : event.deltaY * WHEEL_LINE;
    this.#zoom(this.#screen.x, this.#screen.y, Math.exp(-pixels * WHEEL_RATE));
    this.options.onNavigate?.();
  };

  /** The right button pans, so it opens no menu. */
  readonly menu = (event: Event): void => {
    if (this.options.navigate !== false) event.preventDefault();
  };

  /** Releases every body at rest, for example when the canvas is removed. */
  releaseAll(): void {
    for (const [pointerId, pointer] of this.#pointers) {
      if (pointer.body === 0) continue;
      const world = toWorld(this.options.camera, this.#size, pointer.x, pointer.y, this.#world);
      this.options.onRelease?.(pointer.body, world.x, world.y, 0, 0, pointerId);
    }
    this.#pointers.clear();
  }

  /** Two pointers move the view and scale it about the one at rest; one moves it if it pans alone. */
  #navigate(pointer: Pointer, pointerId: number): void {
    const other = this.#otherNavigating(pointerId);
    if (other === undefined) {
      if (!pointer.pans) return;
      panBy(this.options.camera, this.#screen.x - pointer.x, this.#screen.y - pointer.y);
    } else {
      const before = Math.hypot(pointer.x - other.x, pointer.y - other.y);
      const after = Math.hypot(this.#screen.x - other.x, this.#screen.y - other.y);
      // The midpoint moves half as far as the moving finger.
      panBy(this.options.camera, (this.#screen.x - pointer.x) / 2, (this.#screen.y - pointer.y) / 2);
      const middleX = (this.#screen.x + other.x) / 2;
      const middleY = (this.#screen.y + other.y) / 2;
      if (before > 1 && after > 1) this.#zoom(middleX, middleY, after / before);
    }
    this.options.onNavigate?.();
  }

  #otherNavigating(pointerId: number): Pointer | undefined {
    for (const [id, pointer] of this.#pointers) if (id !== pointerId && pointer.navigates) return pointer;
    return undefined;
  }

  #zoom(x: number, y: number, factor: number): void {
    zoomAt(this.options.camera, this.#size, x, y, factor, this.options.zoomLimits);
  }

  /** Writes the event's position into `#screen` (pixels of the picture) and returns it in world metres. */
  #locate(event: MouseEvent): Vector2 {
    const { camera, viewport } = this.options;
    this.#size.width = viewport?.width ?? this.canvas.clientWidth;
    this.#size.height = viewport?.height ?? this.canvas.clientHeight;
    placeInPicture(this.canvas, event.clientX, event.clientY, this.#size, this.#screen);
    return toWorld(camera, this.#size, this.#screen.x, this.#screen.y, this.#world);
  }
}
