/** The cloth in 3D: triangles between its nodes, lit on both sides. Torn and cut threads open the triangles beside them. */
import { query } from 'bitecs';
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  DynamicDrawUsage,
  Mesh,
  MeshStandardMaterial,
} from 'three';
import { colorAt } from './colors.ts';
import { CLOTH, type ClothRun, threadCount } from './sim.ts';

export interface ClothMesh {
  readonly object: Mesh;
  /** @param alpha position of the picture between the last two steps, 0 to 1 */
  update(alpha: number): void;
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
  const shade = new Color();
  for (let i = 0; i < COUNT; i++) {
    const [red, green, blue] = colorAt(Math.floor(i / columns) / (rows - 1), safeColors);
    shade.setRGB(red, green, blue, 'srgb').toArray(color.array, 3 * i);
  }
  const material = new MeshStandardMaterial({ vertexColors: true, side: DoubleSide, roughness: 0.62 });
  const object = new Mesh(geometry, material);
  // The cloth moves, and its bounds with it.
  object.frustumCulled = false;
  let drawn = -1;
  return {
    object,
    update(alpha) {
      const count = threadCount(sim);
      if (drawn !== count) showTriangles(sim, geometry);
      drawn = count;
      copyPositions(sim, alpha, position.array as Float32Array);
      computeNormals(position.array as Float32Array, normal.array as Float32Array);
      position.needsUpdate = true;
      normal.needsUpdate = true;
    },
    destroy() {
      geometry.dispose();
      material.dispose();
    },
  };
}

/** A cell has two triangles; each needs the two threads along its edges. */
function showTriangles({ world, cloth }: ClothRun, geometry: BufferGeometry): void {
  const { Spring } = world.components;
  const [first] = cloth.nodes;
  /** Whether a node has its threads to the right and downwards. */
  const [right, down] = [new Uint8Array(COUNT), new Uint8Array(COUNT)];
  for (const thread of query(world, [Spring])) {
    const low = Math.min(Spring.a[thread], Spring.b[thread]) - first;
    const difference = Math.abs(Spring.a[thread] - Spring.b[thread]);
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
