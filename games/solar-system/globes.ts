/** Sun, planets and Moon as lit spheres, with the rings of Saturn and the glow of the Sun. */
import { BODY_NAMES, type BodyName } from '@principia/scenes';
import {
  AdditiveBlending,
  CanvasTexture,
  Color,
  DoubleSide,
  Group,
  type Material,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  RingGeometry,
  type SphereGeometry,
  Sprite,
  SpriteMaterial,
  SRGBColorSpace,
  type Texture,
  Vector3,
} from 'three';
import { LOOKS } from './bodies.ts';
import { paintGlow } from './sky.ts';
import { paintSurface } from './surfaces.ts';

const RADIANS = Math.PI / 180;
/** Radii of the rings, in radii of Saturn: from the inner edge of C to the outer edge of A. */
const RINGS = { inner: 1.24, outer: 2.27 } as const;

export interface Globe {
  readonly object: Group;
  /** @param radius in lengths of the picture @param days since 2000, for the turn of the body */
  show(radius: number, days: number): void;
  destroy(): void;
}

export function createGlobe(name: BodyName, sphere: SphereGeometry): Globe {
  const look = LOOKS[name];
  const map = paintSurface(look, 1 + BODY_NAMES.indexOf(name));
  const material =
    name === 'sun'
      ? new MeshBasicMaterial({ map, toneMapped: false })
      : new MeshStandardMaterial({ map, roughness: 1, metalness: 0 });
  const ball = new Mesh(sphere, material);
  const object = new Group();
  const [inclination, longitude] = look.tilt;
  const [tilt, lean] = [inclination * RADIANS, longitude * RADIANS];
  const pole = new Vector3(Math.sin(tilt) * Math.cos(lean), Math.sin(tilt) * Math.sin(lean), Math.cos(tilt));
  const axis = new Group();
  axis.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), pole);
  axis.add(ball);
  object.add(axis);
  const extras = name === 'saturn' ? createRings() : name === 'sun' ? createGlow() : undefined;
  if (extras !== undefined) (name === 'saturn' ? axis : object).add(extras.object);
  return {
    object,
    show(radius, days) {
      object.scale.setScalar(radius);
      ball.rotation.y = 2 * Math.PI * ((days / look.day) % 1);
    },
    destroy() {
      material.dispose();
      map.dispose();
      extras?.destroy();
    },
  };
}

interface Extra {
  readonly object: Mesh | Sprite;
  destroy(): void;
}

function createRings(): Extra {
  const geometry = new RingGeometry(RINGS.inner, RINGS.outer, 128, 1);
  const { position, uv } = geometry.attributes;
  for (let i = 0; i < position.count; i++) {
    const radius = Math.hypot(position.getX(i), position.getY(i));
    uv.setXY(i, (radius - RINGS.inner) / (RINGS.outer - RINGS.inner), 0.5);
  }
  const map = paintRings();
  const material = new MeshBasicMaterial({ map, transparent: true, side: DoubleSide, depthWrite: false });
  const object = new Mesh(geometry, material);
  object.rotation.x = Math.PI / 2;
  return { object, destroy: () => disposeAll(geometry, material, map) };
}

/** Brightness along the radius: C faint, B bright, the gap of Cassini, A, and the gap of Encke in it. */
function paintRings(): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = 256;
  canvas.height = 1;
  const context = canvas.getContext('2d', { willReadFrequently: true }) as CanvasRenderingContext2D;
  const stops = [
    [0, 0.08],
    [0.26, 0.22],
    [0.28, 0.75],
    [0.68, 0.9],
    [0.69, 0.06],
    [0.76, 0.08],
    [0.77, 0.62],
    [0.93, 0.6],
    [0.935, 0.1],
    [0.945, 0.55],
    [0.99, 0.5],
    [1, 0],
  ] as const;
  const gradient = context.createLinearGradient(0, 0, 256, 0);
  for (const [at, alpha] of stops) gradient.addColorStop(at, `rgba(222, 202, 160, ${alpha})`);
  context.fillStyle = gradient;
  context.fillRect(0, 0, 256, 1);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

function createGlow(): Extra {
  const map = paintGlow('rgba(255, 190, 90, 0.55)', 0.08);
  const material = new SpriteMaterial({
    map,
    blending: AdditiveBlending,
    depthWrite: false,
    color: new Color('#ffd9a0'),
  });
  const object = new Sprite(material);
  object.scale.setScalar(7);
  return { object, destroy: () => disposeAll(material, map) };
}

function disposeAll(...parts: readonly (SphereGeometry | RingGeometry | Material | Texture)[]): void {
  for (const part of parts) part.dispose();
}
