/** The camera: it turns about the followed body, which is the origin of the picture, and glides to another one. */
import { createOrbitCamera, fitRendererToParent, type OrbitCamera } from '@principia/render-three';
import type { Insets } from '@principia/shell';
import { PerspectiveCamera, Vector3, type WebGLRenderer } from 'three';
import type { Vector } from './vectors.ts';

const FIELD_OF_VIEW = 45;
const TANGENT = Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
/** Distances of the camera, millions of km. */
const NEAREST = 3e-5;
const FARTHEST = 4e4;
/** How fast the camera approaches its distance, 1/s. */
const ZOOM_RATE = 4;
/** Proportion of free width to height below which orbits need a larger distance. */
const WIDE = 1.3;

/** What panels of the game cover of the window at its sides, CSS pixels. */
export interface Covered {
  readonly left: number;
  readonly right: number;
  readonly bottom: number;
}

export class SolarCamera {
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 1e-6, 1e6);
  readonly #orbit: OrbitCamera;
  readonly #viewport: ReturnType<typeof fitRendererToParent>;
  /** Distance that the camera approaches; 0 where the player chose one. */
  #wanted = 0;
  /** Whether that is the one of a wide window, and a narrow one shall see as much. */
  #isAcross = false;
  /** Width that panels leave free, as a fraction. */
  #freeWidth = 1;
  readonly #spot = new Vector3();
  readonly #screen = { x: 0, y: 0 };

  constructor(renderer: WebGLRenderer, isCalm: boolean) {
    const { camera } = this;
    camera.up.set(0, 0, 1);
    camera.position.set(0.25, -0.8, 0.62);
    this.#orbit = createOrbitCamera({ element: renderer.domElement, camera, followRate: 5 });
    const { controls } = this.#orbit;
    Object.assign(controls, { enablePan: false, minDistance: NEAREST, maxDistance: FARTHEST, enableDamping: !isCalm });
    controls.addEventListener('start', () => {
      this.#wanted = 0;
    });
    this.#orbit.follow(new Vector3());
    this.#viewport = fitRendererToParent(renderer, camera);
  }

  get distance(): number {
    return this.camera.position.distanceTo(this.#orbit.controls.target);
  }

  get height(): number {
    return this.#viewport.height;
  }

  /** Size of a CSS pixel at the distance of a place. */
  readonly pixelAt = ({ x, y, z }: Vector): number =>
    (2 * TANGENT * this.camera.position.distanceTo(this.#spot.set(x, y, z))) / this.#viewport.height;

  /** The place on the canvas, CSS pixels; undefined behind the camera. The result is reused. */
  readonly toScreen = ({ x, y, z }: Vector): { x: number; y: number } | undefined => {
    const { x: px, y: py, z: depth } = this.#spot.set(x, y, z).project(this.camera);
    if (depth > 1) return undefined;
    this.#screen.x = ((px + 1) / 2) * this.#viewport.width;
    this.#screen.y = ((1 - py) / 2) * this.#viewport.height;
    return this.#screen;
  };

  /** Keeps the picture where it is while its origin moves by a vector. */
  shift({ x, y, z }: Vector): void {
    this.#spot.set(x, y, z);
    this.camera.position.add(this.#spot);
    this.#orbit.controls.target.add(this.#spot);
  }

  /**
   * Goes to a distance.
   * @param isAcross whether a narrow window goes farther away, to see as much as a wide one @param atOnce without a glide
   */
  approach(distance: number, isAcross: boolean, atOnce = false): void {
    this.#wanted = distance;
    this.#isAcross = isAcross;
    if (atOnce) this.camera.position.setLength(this.#goal);
  }

  get #goal(): number {
    return this.#wanted * (this.#isAcross ? Math.max(1, WIDE / (this.camera.aspect * this.#freeWidth)) : 1);
  }

  zoom(factor: number): void {
    this.#wanted = 0;
    this.#scale(1 / factor);
  }

  /** Called once a frame. */
  update(seconds: number, insets: Insets, covered: Covered): void {
    if (this.#wanted > 0) this.#scale((this.#goal / this.distance) ** (1 - Math.exp(-ZOOM_RATE * seconds)));
    this.#orbit.update(seconds);
    this.#placeWindow(insets, covered);
    this.camera.updateMatrixWorld();
  }

  destroy(): void {
    this.#orbit.destroy();
    this.#viewport.destroy();
  }

  #scale(factor: number): void {
    const { target } = this.#orbit.controls;
    this.camera.position.sub(target).multiplyScalar(factor).add(target);
  }

  /** Centres the picture in what panels leave free. */
  #placeWindow({ top, right, left }: Insets, covered: Covered): void {
    const { width, height } = this.#viewport;
    const [atLeft, atRight] = [Math.max(left, covered.left), Math.max(right, covered.right)];
    this.#freeWidth = Math.max(0.1, 1 - (atLeft + atRight) / width);
    const dx = (atRight - atLeft) / 2;
    const dy = (covered.bottom - top) / 2;
    const { view } = this.camera;
    if (view?.offsetX === dx && view.offsetY === dy && view.width === width && view.height === height) return;
    this.camera.setViewOffset(width, height, dx, dy, width, height);
  }
}
