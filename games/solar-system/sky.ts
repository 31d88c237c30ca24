/** Stars at a great distance, most of them in a band like the Milky Way. */
import { createRandom } from '@principia/physics';
import { AdditiveBlending, BufferAttribute, BufferGeometry, CanvasTexture, Color, Points, PointsMaterial } from 'three';

const COUNT = 3600;
const TINTS = ['#ffffff', '#cfdcff', '#aac2ff', '#fff0d8', '#ffd6ae'];

export interface Sky {
  readonly object: Points;
  destroy(): void;
}

export function createSky(distance: number): Sky {
  const random = createRandom(3, 11);
  const positions = new Float32Array(3 * COUNT);
  const colors = new Float32Array(3 * COUNT);
  const tint = new Color();
  for (let i = 0; i < COUNT; i++) {
    const inBand = i % 2 === 0;
    const longitude = random.uniform(0, 2 * Math.PI);
    const height = random.uniform(-1, 1);
    // The band is inclined to the ecliptic by 60°, as the galaxy is.
    const z = inBand ? 0.16 * height * Math.abs(height) : height;
    const r = Math.sqrt(1 - z * z);
    const [x, y] = [r * Math.cos(longitude), r * Math.sin(longitude)];
    positions.set([distance * x, distance * (0.5 * y - 0.866 * z), distance * (0.866 * y + 0.5 * z)], 3 * i);
    // Few stars are bright.
    const light = 0.3 + 0.7 * random.uniform() ** 4;
    tint.set(TINTS[random.integer(0, TINTS.length - 1)]).multiplyScalar(inBand ? 0.8 * light : light);
    colors.set([tint.r, tint.g, tint.b], 3 * i);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('color', new BufferAttribute(colors, 3));
  const map = paintGlow('rgba(255, 255, 255, 0.9)', 0.4);
  const material = new PointsMaterial({
    size: 3.2,
    sizeAttenuation: false,
    vertexColors: true,
    map,
    blending: AdditiveBlending,
    depthWrite: false,
    transparent: true,
  });
  const object = new Points(geometry, material);
  object.frustumCulled = false;
  return {
    object,
    destroy() {
      geometry.dispose();
      material.dispose();
      map.dispose();
    },
  };
}

/** A soft round spot. @param core fraction of the radius within which it is fully bright */
export function paintGlow(color: string, core: number): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const context = canvas.getContext('2d', { willReadFrequently: true }) as CanvasRenderingContext2D;
  const glow = context.createRadialGradient(32, 32, 0, 32, 32, 32);
  glow.addColorStop(0, color);
  glow.addColorStop(core, color);
  glow.addColorStop(1, 'rgba(0, 0, 0, 0)');
  context.fillStyle = glow;
  context.fillRect(0, 0, 64, 64);
  return new CanvasTexture(canvas);
}
