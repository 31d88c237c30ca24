/** The cloth in 3D: triangles between its nodes, lit on both sides. Torn and cut threads open the triangles beside them. */
import {
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  Color,
  DoubleSide,
  DynamicDrawUsage,
  Mesh,
  MeshStandardMaterial,
  SRGBColorSpace,
} from 'three';
import type { ClothPrint } from './cloth-print.ts';
import { colorAt } from './colors.ts';
import { CLOTH, type ClothRun, threadCount } from './sim.ts';
import type { TearFilm } from './tear-film.ts';
import { threadEnds } from './thread-ends.ts';

export interface ClothMesh {
  readonly object: Mesh;
  /**
   * @param alpha position of the picture between the last two steps, 0 to 1
   * @param film shown instead of the world while it runs
   */
  update(alpha: number, film: TearFilm, print: ClothPrint): void;
  destroy(): void;
}

const { columns, rows } = CLOTH;
const COUNT = columns * rows;

export function createClothMesh(sim: ClothRun, safeColors: boolean): ClothMesh {
  const geometry = new BufferGeometry();
  const attribute = () => new BufferAttribute(new Float32Array(3 * COUNT), 3).setUsage(DynamicDrawUsage);
  const [position, normal, color] = [attribute(), attribute(), attribute()];
  geometry.setAttribute('position', position).setAttribute('normal', normal).setAttribute('color', color);
  geometry.setIndex(new BufferAttribute(new Uint16Array(6 * (columns - 1) * (rows - 1)), 1));
  geometry.setAttribute('uv', new BufferAttribute(gridPlaces(), 2));
  const material = new MeshStandardMaterial({ vertexColors: true, side: DoubleSide, roughness: 0.62 });
  const object = new Mesh(geometry, material);
  // The cloth moves, and its bounds with it.
  object.frustumCulled = false;
  const shown = { threads: -1, print: -1 };
  return {
    object,
    update(alpha, film, print) {
      const threads = film.time === undefined ? threadCount(sim) : film.threads;
      if (shown.threads !== threads) showTriangles(threadEnds(sim, film.time), geometry);
      shown.threads = threads;
      if (shown.print !== print.version) applyPrint(material, color, print, safeColors);
      shown.print = print.version;
      const places = position.array as Float32Array;
      if (film.time === undefined) copyPositions(sim, alpha, places);
      else places.set(film.positions);
      computeNormals(places, normal.array as Float32Array);
      position.needsUpdate = true;
      normal.needsUpdate = true;
    },
    destroy() {
      geometry.dispose();
      material.map?.dispose();
      material.dispose();
    },
  };
}

/** Where each node lies on the uncut cloth: shares of its width and height, from the lower left corner. */
function gridPlaces(): Float32Array {
  const places = new Float32Array(2 * COUNT);
  for (let i = 0; i < COUNT; i++) {
    places[2 * i] = (i % columns) / (columns - 1);
    places[2 * i + 1] = 1 - Math.floor(i / columns) / (rows - 1);
  }
  return places;
}

/** Shows the player's picture, or without one the colours of the cloth. */
function applyPrint(
  material: MeshStandardMaterial,
  color: BufferAttribute,
  print: ClothPrint,
  safeColors: boolean,
): void {
  material.map?.dispose();
  material.map = print.canvas === undefined ? null : new CanvasTexture(print.canvas);
  if (material.map !== null) {
    material.map.colorSpace = SRGBColorSpace;
    material.map.anisotropy = 4;
  }
  material.needsUpdate = true;
  const shade = new Color();
  for (let i = 0; i < COUNT; i++) {
    const [red, green, blue] =
      print.canvas === undefined ? colorAt(Math.floor(i / columns) / (rows - 1), safeColors) : [1, 1, 1];
    shade.setRGB(red, green, blue, 'srgb').toArray(color.array, 3 * i);
  }
  color.needsUpdate = true;
}

/** A cell has two triangles; each needs the two threads along its edges. @param ends the two nodes of each thread */
function showTriangles(ends: readonly number[], geometry: BufferGeometry): void {
  /** Whether a node has its threads to the right and downwards. */
  const [right, down] = [new Uint8Array(COUNT), new Uint8Array(COUNT)];
  for (let i = 0; i < ends.length; i += 2) {
    const low = Math.min(ends[i], ends[i + 1]);
    const difference = Math.abs(ends[i] - ends[i + 1]);
    if (difference === 1) right[low] = 1;
    else if (difference === columns) down[low] = 1;
  }
  const index = geometry.index as BufferAttribute;
  let used = 0;
  const add = (a: number, b: number, c: number) => {
    index.setX(used++, a);
    index.setX(used++, b);
    index.setX(used++, c);
  };
  for (let row = 0; row < rows - 1; row++) {
    for (let column = 0; column < columns - 1; column++) {
      const node = row * columns + column;
      if (right[node] && down[node]) add(node, node + columns, node + 1);
      if (right[node + columns] && down[node + 1]) add(node + 1, node + columns, node + columns + 1);
    }
  }
  index.needsUpdate = true;
  geometry.setDrawRange(0, used);
}

function copyPositions({ world, cloth }: ClothRun, alpha: number, out: Float32Array): void {
  const { Position } = world.components;
  const old = world.previous.Position;
  const [first] = cloth.nodes;
  for (let i = 0; i < COUNT; i++) {
    const id = first + i;
    out[3 * i] = old.x[id] + (Position.x[id] - old.x[id]) * alpha;
    out[3 * i + 1] = old.y[id] + (Position.y[id] - old.y[id]) * alpha;
    out[3 * i + 2] = old.z[id] + (Position.z[id] - old.z[id]) * alpha;
  }
}

/** The normal at a node is perpendicular to the lines between its neighbours in its row and in its column. */
function computeNormals(position: Float32Array, normal: Float32Array): void {
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const node = row * columns + column;
      const left = 3 * (node - (column > 0 ? 1 : 0));
      const right = 3 * (node + (column < columns - 1 ? 1 : 0));
      const above = 3 * (node - (row > 0 ? columns : 0));
      const below = 3 * (node + (row < rows - 1 ? columns : 0));
      const ax = position[right] - position[left];
      const ay = position[right + 1] - position[left + 1];
      const az = position[right + 2] - position[left + 2];
      const bx = position[above] - position[below];
      const by = position[above + 1] - position[below + 1];
      const bz = position[above + 2] - position[below + 2];
      normal[3 * node] = ay * bz - az * by;
      normal[3 * node + 1] = az * bx - ax * bz;
      normal[3 * node + 2] = ax * by - ay * bx;
    }
  }
}
