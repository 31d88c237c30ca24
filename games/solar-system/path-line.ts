/** A line through points relative to the Sun: the path that lies ahead, or the one that was flown. */
import { BufferAttribute, BufferGeometry, Color, Line, LineBasicMaterial, LineDashedMaterial } from 'three';

export interface PathLine {
  readonly object: Line;
  /** Adds a point and drops the oldest one where there is no room, lengths of the picture. */
  add(x: number, y: number, z: number): void;
  /** Shows these points, of three numbers each, from the point `first` on. */
  set(points: Float64Array, count: number, scale: number): void;
  /** Makes dashes equally long on the screen. @param distance of the camera from its target */
  setScale(distance: number): void;
  clear(): void;
  destroy(): void;
}

export function createPathLine(color: string, capacity: number, isDashed: boolean, opacity = 0.9): PathLine {
  const positions = new BufferAttribute(new Float32Array(3 * capacity), 3);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', positions);
  geometry.setDrawRange(0, 0);
  const look = { color: new Color(color), transparent: true, opacity, depthWrite: false };
  const material = isDashed
    ? new LineDashedMaterial({ ...look, dashSize: 3, gapSize: 2 })
    : new LineBasicMaterial(look);
  const object = new Line(geometry, material);
  object.frustumCulled = false;
  const { array } = positions;
  let count = 0;
  const show = () => {
    geometry.setDrawRange(0, count);
    positions.needsUpdate = true;
    if (isDashed && count > 1) object.computeLineDistances();
  };
  return {
    object,
    add(x, y, z) {
      if (count === capacity) {
        array.copyWithin(0, 3);
        count--;
      }
      array.set([x, y, z], 3 * count++);
      show();
    },
    set(points, length, scale) {
      count = Math.min(length, capacity);
      for (let i = 0; i < 3 * count; i++) array[i] = scale * points[i];
      show();
    },
    setScale(distance) {
      if (material instanceof LineDashedMaterial) material.scale = 250 / distance;
    },
    clear() {
      count = 0;
      show();
    },
    destroy() {
      geometry.dispose();
      material.dispose();
    },
  };
}
