/** What there is to knock down. Each build stands on the ground, whose surface is y = 0, about x = 0. */
import {
  box,
  capsule,
  circle,
  createJoint,
  type PhysicsWorld,
  polygon,
  revolute,
  type Shape,
  spawn,
} from '@principia/physics';

/** The surface of all bodies of a build. */
export interface Material {
  readonly friction: number;
  readonly restitution: number;
}

/** Of 10 cm thickness, kg/m². */
const WOOD = 60;
const STONE = 250;
/** Balls that lose nothing when they hit each other. */
const STEEL = { density: 780, friction: 0, restitution: 1 };
/** Space between bodies of a new build, m: less than what a contact leaves open. */
const GAP = 0.002;

type Place = { readonly x: number; readonly y: number; readonly angle?: number };

/** Adds bodies of one material to a world. */
class Builder {
  readonly world: PhysicsWorld;
  readonly #material: Material;

  constructor(world: PhysicsWorld, material: Material) {
    this.world = world;
    this.#material = material;
  }

  add(shape: Shape, { x, y, angle = 0 }: Place, density = WOOD, material = this.#material): number {
    const collider = { shape, density, ...material };
    return spawn(this.world, { position: { x, y }, rotation: angle, collider, appearance: {} });
  }

  addStatic(shape: Shape, { x, y }: Place): number {
    return spawn(this.world, { position: { x, y }, collider: { shape, ...this.#material }, appearance: {} });
  }
}

type Build = (builder: Builder, count: number) => void;

/** Towers with storeys of two posts and a beam. */
const tower: Build = (builder, count) => {
  const [post, beam] = [box(0.25, 1), box(2, 0.25)];
  const columns = Math.max(1, Math.round(Math.sqrt(count / 6)));
  const storeys = Math.max(1, Math.round(count / columns / 3));
  for (let column = 0; column < columns; column++) {
    const x = 2.6 * (column - (columns - 1) / 2);
    for (let storey = 0; storey < storeys; storey++) {
      const y = storey * (1.25 + 2 * GAP);
      for (const side of [-0.8, 0.8]) builder.add(post, { x: x + side, y: y + 0.5 + GAP });
      builder.add(beam, { x, y: y + 1.125 + 2 * GAP });
    }
  }
};

const pyramid: Build = (builder, count) => {
  const rows = Math.max(1, Math.round((Math.sqrt(8 * count + 1) - 1) / 2));
  const brick = box(0.8, 0.4);
  for (let row = 0; row < rows; row++) {
    for (let i = 0; i < rows - row; i++) {
      builder.add(brick, { x: (0.8 + GAP) * (i - (rows - row - 1) / 2), y: row * (0.4 + GAP) + 0.2 + GAP });
    }
  }
};

/** Dominoes in rows on shelves; the first of each row leans. */
const dominoes: Build = (builder, count) => {
  const rows = Math.max(1, Math.round(Math.sqrt(count / 40)));
  const length = Math.ceil(count / rows);
  const domino = box(0.12, 1);
  for (let row = 0; row < rows; row++) {
    const y = 2 * row;
    if (row > 0) builder.addStatic(box(0.5 * length, 0.1), { x: 0, y: y - 0.05 });
    for (let i = 0; i < length; i++) {
      // Turned by a quarter of its thickness over its height, the first one is past its balance.
      const angle = i === 0 ? -0.16 : 0;
      builder.add(domino, { x: 0.48 * (i - (length - 1) / 2), y: y + 0.5 + (i === 0 ? 0.004 : GAP), angle });
    }
  }
};

/** A bridge of hinged planks with a load of balls and blocks. */
const bridge: Build = (builder, count) => {
  const planks = Math.min(120, Math.max(8, Math.round(count / 2)));
  const plank = box(0.5, 0.25);
  const width = 0.5 * planks;
  const y = 3;
  const piers = [-1, 1].map((side) => builder.addStatic(box(1, y), { x: side * (width / 2 + 0.5), y: y / 2 }));
  let last = piers[0];
  for (let i = 0; i <= planks; i++) {
    const x = -width / 2 + 0.5 * i;
    const next = i === planks ? piers[1] : builder.add(plank, { x: x + 0.25, y: y - 0.125 }, STONE);
    createJoint(builder.world, revolute({ a: last, b: next, anchor: { x, y: y - 0.125 } }));
    last = next;
  }
  const load = [capsule(0.5, 0.2), box(0.5, 0.5)];
  for (let i = 0; i < count - planks; i++) {
    const place = { x: 0.7 * ((i % 20) - 9.5), y: y + 0.3 + 0.6 * Math.floor(i / 20) };
    builder.add(load[i % 2], place);
  }
};

/** Boxes, capsules and polygons that fall in a heap. */
const mixed: Build = (builder, count) => {
  const hexagon = [0, 1, 2, 3, 4, 5].map((i) => ({
    x: 0.35 * Math.cos((i * Math.PI) / 3),
    y: 0.35 * Math.sin((i * Math.PI) / 3),
  }));
  const shapes = [
    box(0.6, 0.6),
    capsule(0.5, 0.2),
    polygon(hexagon),
    polygon([
      { x: 0, y: 0 },
      { x: 0.7, y: 0 },
      { x: 0.35, y: 0.6 },
    ]),
  ];
  const columns = Math.max(4, Math.round(Math.sqrt(count)));
  for (let i = 0; i < count; i++) {
    const row = Math.floor(i / columns);
    const x = 0.85 * ((i % columns) - (columns - 1) / 2) + 0.2 * (row % 2);
    builder.add(shapes[(i + row) % shapes.length], { x, y: 0.6 + 0.85 * row, angle: (i % 7) * 0.4 });
  }
};

/** Balls that hang side by side from beams; of each row some are pulled aside. */
const cradles: Build = (builder, count) => {
  const [balls, radius, length, angle] = [5, 0.3, 2.4, 0.7];
  // About one and a half times as wide as high.
  const rows = Math.max(1, Math.round(Math.sqrt((1.4 * count) / balls)));
  const columns = Math.max(1, Math.round(count / balls / rows));
  const [beam, ball] = [box(2 * radius * balls, 0.15), circle(radius)];
  for (let i = 0; i < rows * columns; i++) {
    const x = 6.6 * ((i % columns) - (columns - 1) / 2);
    const y = 3.2 * (Math.floor(i / columns) + 1);
    const a = builder.addStatic(beam, { x, y });
    for (let k = 0; k < balls; k++) {
      const anchor = { x: x + 2 * radius * (k - (balls - 1) / 2), y };
      const aside = k <= i % (balls - 1) ? angle : 0;
      const place = { x: anchor.x - length * Math.sin(aside), y: y - length * Math.cos(aside) };
      const b = builder.add(ball, place, STEEL.density, STEEL);
      createJoint(builder.world, revolute({ a, b, anchor }));
    }
  }
};

const BUILDS: Readonly<Record<string, Build>> = { tower, pyramid, dominoes, bridge, cradles, mixed };

/** Builds one of the choices of the panel. */
export function build(world: PhysicsWorld, name: string, count: number, material: Material): void {
  BUILDS[name](new Builder(world, material), count);
}
