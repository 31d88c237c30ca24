/** What stands still: sky, ground, runway with its lights, trees and hangars. */
import {
  BoxGeometry,
  BufferAttribute,
  CanvasTexture,
  Color,
  ConeGeometry,
  DirectionalLight,
  EquirectangularReflectionMapping,
  Fog,
  HemisphereLight,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  PlaneGeometry,
  RepeatWrapping,
  type Scene,
  SRGBColorSpace,
} from 'three';
import { groundHeight, MAP_RADIUS, RUNWAY } from './terrain.ts';

const HAZE = '#c9d6e2';
/** Distance of vertices of the ground, m. */
const CELL = 110;
const TREES = 1100;

/** Paints a texture on a canvas. */
export function painted(
  width: number,
  height: number,
  paint: (context: CanvasRenderingContext2D) => void,
): CanvasTexture {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext('2d');
  if (context === null) throw new Error('This browser offers no 2D canvas.');
  paint(context);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

/** The same pseudo-random numbers in every flight. */
function randomSequence(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

export function addScenery(scene: Scene): void {
  scene.background = sky();
  scene.fog = new Fog(HAZE, 2500, 13000);
  const sun = new DirectionalLight(0xfff0d8, 2.4);
  sun.position.set(-0.6, 0.7, 0.5);
  scene.add(
    sun,
    new HemisphereLight(0xd4e4ff, 0x6b7350, 1.5),
    ground(),
    beyond(),
    runway(),
    lights(),
    trees(),
    ...hangars(),
  );
}

function sky(): CanvasTexture {
  const texture = painted(8, 512, (context) => {
    const gradient = context.createLinearGradient(0, 0, 0, 512);
    for (const [at, color] of [
      [0, '#2f6fc4'],
      [0.3, '#6aa2df'],
      [0.45, '#b5d0ea'],
      [0.5, HAZE],
      [0.52, HAZE],
      [1, '#8a9a86'],
    ] as const) {
      gradient.addColorStop(at, color);
    }
    context.fillStyle = gradient;
    context.fillRect(0, 0, 8, 512);
  });
  texture.mapping = EquirectangularReflectionMapping;
  return texture;
}

const GRASS = new Color('#7f9f55');
const MEADOW = new Color('#a3ad62');
const FOREST = new Color('#476b42');
const ROCK = new Color('#8b8478');

function ground(): Mesh {
  const size = 2 * (MAP_RADIUS + 1500);
  const geometry = new PlaneGeometry(size, size, Math.round(size / CELL), Math.round(size / CELL)).rotateX(
    -Math.PI / 2,
  );
  const positions = geometry.attributes.position;
  const colors = new Float32Array(3 * positions.count);
  const color = new Color();
  const random = randomSequence(5);
  for (let i = 0; i < positions.count; i++) {
    const [x, z] = [positions.getX(i), positions.getZ(i)];
    const height = groundHeight(x, z);
    positions.setY(i, height);
    // Fields of half a kilometre, forest on the slopes, rock above.
    const field = (Math.floor(x / 480) * 7 + Math.floor(z / 390) * 13) % 5;
    color.copy(field === 0 || field === -3 ? MEADOW : GRASS);
    color.lerp(FOREST, Math.min(1, height / 60)).lerp(ROCK, Math.min(1, Math.max(0, (height - 230) / 120)));
    color.multiplyScalar(0.92 + 0.16 * random());
    color.toArray(colors, 3 * i);
  }
  geometry.setAttribute('color', new BufferAttribute(colors, 3));
  geometry.computeVertexNormals();
  const grain = painted(128, 128, (context) => {
    const shade = randomSequence(9);
    for (let i = 0; i < 128 * 128; i++) {
      const level = Math.round(215 + 40 * shade());
      context.fillStyle = `rgb(${level},${level},${level})`;
      context.fillRect(i % 128, Math.floor(i / 128), 1, 1);
    }
    for (let i = 0; i < 60; i++) {
      context.fillStyle = `rgba(70,90,40,${0.1 + 0.15 * shade()})`;
      context.fillRect(128 * shade(), 128 * shade(), 4 + 14 * shade(), 3 + 8 * shade());
    }
  });
  grain.wrapS = RepeatWrapping;
  grain.wrapT = RepeatWrapping;
  grain.repeat.set(size / 60, size / 60);
  return new Mesh(geometry, new MeshLambertMaterial({ vertexColors: true, map: grain }));
}

/** Level land up to the horizon. */
function beyond(): Mesh {
  const mesh = new Mesh(
    new PlaneGeometry(60_000, 60_000).rotateX(-Math.PI / 2),
    new MeshLambertMaterial({ color: '#7d9170' }),
  );
  mesh.position.y = -25;
  return mesh;
}

function runway(): Mesh {
  const texture = painted(4096, 128, (context) => {
    const metre = 4096 / RUNWAY.length;
    const across = 128 / RUNWAY.width;
    context.fillStyle = '#53565c';
    context.fillRect(0, 0, 4096, 128);
    context.fillStyle = '#f4f4f0';
    for (let x = 90; x < RUNWAY.length - 90; x += 50) context.fillRect(x * metre, 63, 30 * metre, 3);
    for (const from of [8, RUNWAY.length - 38]) {
      for (let z = 3; z < RUNWAY.width - 3; z += 4) context.fillRect(from * metre, z * across, 30 * metre, 2 * across);
    }
    for (const from of [250, RUNWAY.length - 300]) {
      for (const z of [8, 24]) context.fillRect(from * metre, z * across, 50 * metre, 4 * across);
    }
    for (const z of [0, 125]) context.fillRect(0, z, 4096, 3);
    // The numbers are read by the one who lands there.
    context.font = '700 52px sans-serif';
    context.textAlign = 'center';
    for (const [x, turn, text] of [
      [60, Math.PI / 2, '09'],
      [RUNWAY.length - 60, -Math.PI / 2, '27'],
    ] as const) {
      context.save();
      context.translate(x * metre, 64);
      context.rotate(turn);
      context.fillText(text, 0, 18);
      context.restore();
    }
  });
  // Numbers and lines are seen nearly from the side. Not the ground, too: with a texture that repeats so often Firefox on a machine
  // without a graphics card does not finish a picture in a minute.
  texture.anisotropy = 8;
  const geometry = new PlaneGeometry(RUNWAY.length, RUNWAY.width).rotateX(-Math.PI / 2);
  const material = new MeshLambertMaterial({
    map: texture,
    polygonOffset: true,
    polygonOffsetFactor: -4,
    polygonOffsetUnits: -40,
  });
  const mesh = new Mesh(geometry, material);
  mesh.position.y = 0.02;
  return mesh;
}

/** White lights along the edges, green where it begins and red where it ends, as one lands. */
function lights(): InstancedMesh {
  const places: [number, number, number][] = [];
  const [half, edge] = [RUNWAY.length / 2, RUNWAY.width / 2 + 1.5];
  for (let x = -half; x <= half; x += 60) places.push([x, -edge, 0xfff3c4], [x, edge, 0xfff3c4]);
  for (let z = -edge; z <= edge; z += 4) places.push([-half - 2, z, 0x4dff9a], [half + 2, z, 0xff5a4d]);
  const mesh = new InstancedMesh(new BoxGeometry(0.7, 0.7, 0.7), new MeshBasicMaterial({ fog: false }), places.length);
  const matrix = new Matrix4();
  const color = new Color();
  places.forEach(([x, z, light], i) => {
    mesh.setMatrixAt(i, matrix.makeTranslation(x, 0.4, z));
    mesh.setColorAt(i, color.setHex(light));
  });
  return mesh;
}

function trees(): InstancedMesh {
  const geometry = new ConeGeometry(3.2, 11, 6).translate(0, 5, 0);
  const mesh = new InstancedMesh(geometry, new MeshLambertMaterial({ flatShading: true }), TREES);
  const random = randomSequence(77);
  const matrix = new Matrix4();
  const color = new Color();
  for (let i = 0; i < TREES; i++) {
    let [x, z] = [0, 0];
    // Not on the airfield, nor in the way of an approach.
    do {
      x = (random() - 0.5) * 7000;
      z = (random() - 0.5) * 5000;
    } while (Math.abs(z) < 130);
    const size = 0.6 + 0.8 * random();
    matrix.makeScale(size, size, size).setPosition(x, groundHeight(x, z), z);
    mesh.setMatrixAt(i, matrix);
    mesh.setColorAt(i, color.setHSL(0.28 + 0.06 * random(), 0.34, 0.22 + 0.1 * random()));
  }
  return mesh;
}

/** Hangars and a tower south of the runway. */
function hangars(): Mesh[] {
  const box = (x: number, z: number, width: number, height: number, depth: number, color: string) => {
    const mesh = new Mesh(new BoxGeometry(width, height, depth), new MeshLambertMaterial({ color }));
    mesh.position.set(x, height / 2, z);
    return mesh;
  };
  const top = box(10, 88, 14, 6, 14, '#6f93b5');
  top.position.y = 26;
  return [
    top,
    box(-160, 95, 36, 10, 26, '#b9c4cf'),
    box(-110, 95, 36, 10, 26, '#a8b6c4'),
    box(-60, 95, 36, 10, 26, '#c7b9a3'),
    box(10, 88, 9, 24, 9, '#e4e0d6'),
    box(60, 92, 44, 8, 18, '#d8cdb9'),
  ];
}
