/** The 3D landscape: a dome of sky, a ring of hills and town, and a lake. */
import {
  BackSide,
  BufferAttribute,
  CanvasTexture,
  CircleGeometry,
  Color,
  CylinderGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  RingGeometry,
  SphereGeometry,
  SRGBColorSpace,
} from 'three';
import { HORIZON_COLOR, paintShore, paintSky } from './landscape.ts';

/** Distance of the shore and height of its painting, m. */
const SHORE = 150;
const SHORE_HEIGHT = 30;
/** Colour of the hills. */
const LAND_COLOR = 0x0c1030;
/** Radius of the sky dome, m. */
const SKY = 900;

export interface World3D {
  readonly object: Object3D;
  destroy(): void;
}

export function createWorld3D(): World3D {
  const sky = textureOf(paintSky({ width: 4096, height: 1400, horizon: 1400, scale: 0 }));
  const scale = 4096 / (2 * Math.PI * SHORE);
  const height = Math.round(SHORE_HEIGHT * scale);
  const shore = textureOf(paintShore({ width: 4096, height, horizon: height, scale: 1.7 * scale }));
  // The sky texture ends at the horizon, so the dome is a hemisphere.
  const dome = new Mesh(new SphereGeometry(SKY, 48, 24, 0, 2 * Math.PI, 0, Math.PI / 2), plain({ map: sky }));
  const ring = new Mesh(
    new CylinderGeometry(SHORE, SHORE, SHORE_HEIGHT, 96, 1, true),
    plain({ map: shore, transparent: true }),
  );
  ring.position.y = SHORE_HEIGHT / 2;
  const lake = new Mesh(new CircleGeometry(SHORE, 96), new MeshBasicMaterial({ color: 0x0a0f2a }));
  // The land behind the town.
  const land = new Mesh(landGeometry(), new MeshBasicMaterial({ vertexColors: true }));
  for (const flat of [lake, land]) flat.rotation.x = -Math.PI / 2;
  const parts = [dome, ring, lake, land];
  const object = new Group().add(...parts);
  return {
    object,
    destroy() {
      for (const { geometry, material } of parts) {
        geometry.dispose();
        material.dispose();
      }
      sky.dispose();
      shore.dispose();
    },
  };
}

/** The land fades into the colour of the sky at the horizon, as haze makes it, so that no edge shows between them. */
function landGeometry(): RingGeometry {
  const geometry = new RingGeometry(SHORE, SKY, 96, 12);
  const { position } = geometry.attributes;
  const colors = new Float32Array(3 * position.count);
  const color = new Color();
  const haze = new Color(HORIZON_COLOR);
  for (let i = 0; i < position.count; i++) {
    const distance = Math.hypot(position.getX(i), position.getY(i));
    // From above the lake, nearly all of the land lies close to the horizon: the haze grows fast with the distance.
    const share = Math.min(1, ((distance - SHORE) / (SKY - SHORE)) ** 0.3);
    color
      .set(LAND_COLOR)
      .lerp(haze, share)
      .toArray(colors, 3 * i);
  }
  return geometry.setAttribute('color', new BufferAttribute(colors, 3)) as RingGeometry;
}

function plain(options: { map: CanvasTexture; transparent?: boolean }): MeshBasicMaterial {
  return new MeshBasicMaterial({ ...options, side: BackSide, depthWrite: false });
}

function textureOf(canvas: HTMLCanvasElement): CanvasTexture {
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 4;
  return texture;
}
