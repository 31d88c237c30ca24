import {
  angularDrag,
  box,
  buoyancy,
  createJoint,
  createPhysicsWorld,
  despawn,
  distance,
  exp,
  type FluidVolume,
  immersedDrag,
  type PhysicsWorld,
  polygon,
  polygonBuoyancy,
  rgba,
  rigidBodies,
  sin,
  spawn,
  surfaceHeight,
  uniformGravity,
  weld,
} from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { momentsOf } from '../support/figure.ts';
import { placeOn } from '../support/outline.ts';
import { positionOf } from '../support/read.ts';

type Values = ValuesOf<'amplitude' | 'length' | 'mast'>;

const [GRAVITY, WATER] = [9.81, 1000];
const VIEW = { minX: -9, maxX: 9, minY: -5.5, maxY: 5 };

/** The hull about its centre of mass, from above its deck to its keel, and what it weighs, kg: a metre deep, as everything here. */
const OUTLINE = [
  { x: -1.6, y: 0.5 },
  { x: -1.2, y: -0.4 },
  { x: 1.2, y: -0.4 },
  { x: 1.6, y: 0.5 },
];
const HULL = momentsOf(OUTLINE);
const CORNERS = OUTLINE.map(({ x, y }) => ({ x: x - HULL.centre.x, y: y - HULL.centre.y }));
const [KEEL, DECK] = [CORNERS[1].y, CORNERS[0].y];
/** Widths at the keel and at the deck, m, and by how much the hull is wider a metre higher. */
const [NARROW, WIDE] = [CORNERS[2].x - CORNERS[1].x, CORNERS[3].x - CORNERS[0].x];
const FLARE = (WIDE - NARROW) / (DECK - KEEL);
const DENSITY = 300;
const LAMP = { mass: 200, radius: 0.25 };

/** Drops of water at these depths, m. */
const DEEPEST = 3.6;
const DEPTHS = [0.6, 1.2, 1.8, 2.4, 3, DEEPEST];
/** Of the boat, on the bottom of the sea. */
const ANCHOR = { x: -7, y: -5.2 };
const MOST_CRATES = 12;
const CRATE = 0.5;

const seaOf = ({ amplitude, length }: Values): FluidVolume => ({
  density: WATER,
  gravity: { y: -GRAVITY },
  level: 0,
  ...(amplitude > 0 ? { waves: { amplitude, length } } : {}),
});

/** Depth of the keel at which the hull carries a mass, m: half the sum of two parallel sides, times the depth. */
function draughtFor(mass: number): number {
  const area = mass / WATER;
  // NARROW d + FLARE d²/2 = area
  return (2 * area) / (NARROW + Math.sqrt(NARROW * NARROW + 2 * FLARE * area));
}

/** Everything that turns as the boat rolls: mass, kg, height of its centre above the keel, m, moment of inertia about it, kg m². */
function loadOf(mast: number): { mass: number; height: number; inertia: number } {
  const hull = DENSITY * HULL.area;
  const lampAt = DECK + mast - KEEL;
  const mass = hull + LAMP.mass;
  const height = (hull * -KEEL + LAMP.mass * lampAt) / mass;
  const [a, b] = [-KEEL - height, lampAt - height];
  const lamp = LAMP.mass * ((LAMP.radius * LAMP.radius) / 2 + b * b);
  return { mass, height, inertia: DENSITY * HULL.inertia + hull * a * a + lamp };
}

/** Height of the metacentre above the centre of mass, m: that of the centre of buoyancy, and width³/12 by the area under water. */
function metacentreOf(mast: number): number {
  const { mass, height } = loadOf(mast);
  const draught = draughtFor(mass);
  const width = NARROW + FLARE * draught;
  const centre = (draught / 3) * ((NARROW + 2 * width) / (NARROW + width));
  return centre + (width * width * width) / 12 / (mass / WATER) - height;
}

/** A boat with a lamp on its mast. */
function launchBoat(world: PhysicsWorld, x: number, angle: number, { mast }: Values): number {
  const y = -draughtFor(loadOf(mast).mass) - KEEL;
  const boat = spawn(world, {
    position: { x, y },
    rotation: angle,
    collider: { shape: polygon(CORNERS), density: DENSITY, friction: 0.6 },
    hull: { volume: HULL.area, shape: 2, halfHeight: (DECK - KEEL) / 2 },
    linearDrag: 100,
    quadraticDrag: 300,
    angularDrag: 60,
    appearance: rgba(0.82, 0.5, 0.3),
  });
  const top = placeOn(world, boat, { x: 0, y: DECK + mast });
  const lamp = spawn(world, {
    position: top,
    collider: { radius: LAMP.radius, density: LAMP.mass / (Math.PI * LAMP.radius * LAMP.radius) },
    appearance: rgba(1, 0.8, 0.3),
  });
  createJoint(world, weld({ a: boat, b: lamp, anchor: top }));
  return boat;
}

/** Period of a small roll, s: as of a pendulum whose pivot is the metacentre. */
function rollPeriod(mast: number): number {
  const { mass, inertia } = loadOf(mast);
  return 2 * Math.PI * Math.sqrt(inertia / (mass * GRAVITY * metacentreOf(mast)));
}

const waveNumberOf = (length: number) => (2 * Math.PI) / length;
/** Angular frequency of waves on deep water, rad/s. */
const rateOf = (length: number) => Math.sqrt(GRAVITY * waveNumberOf(length));

/** The circle of a drop that starts below a crest: its radius, m, is a e^(k z) for the height z of its centre, here found by iteration. */
function orbitOf(depth: number, { amplitude, length }: Pick<Values, 'amplitude' | 'length'>): number {
  let radius = 0;
  for (let i = 0; i < 50; i++) radius = amplitude * exp(waveNumberOf(length) * (-depth - radius));
  return radius;
}

/** Where it is after a time: on a circle whose centre drifts at r² ω k. Stokes, On the Theory of Oscillatory Waves (1847). */
function placeAfter(time: number, depth: number, values: Pick<Values, 'amplitude' | 'length'>): number {
  const [k, rate, radius] = [waveNumberOf(values.length), rateOf(values.length), orbitOf(depth, values)];
  const centre = radius * radius * rate * k * time;
  return centre + radius * sin(rate * time - k * centre);
}

/** A drop of water that goes with the wave: it starts below a crest. */
function addDrop(world: PhysicsWorld, depth: number, { amplitude, length }: Values): number {
  return spawn(world, {
    position: { x: 0, y: -depth },
    velocity: { x: amplitude * rateOf(length) * exp(-waveNumberOf(length) * depth) },
    mass: 1,
    hull: { volume: 1 / WATER, halfHeight: 0.01 },
    // Sub-steps of first order would let it sink by 3 cm in 40 s.
    linearDrag: 5,
    appearance: { size: 0.07, color: rgba(1, 1, 1, 0.9) },
  });
}

/** A crate; of more than a dozen the oldest goes. */
function dropCrate(world: PhysicsWorld, crates: number[], { x, y }: Point): void {
  if (crates.length === MOST_CRATES) despawn(world, crates.shift() as number);
  const crate = spawn(world, {
    position: { x, y },
    collider: { shape: box(CRATE, CRATE), density: 400, friction: 0.6 },
    hull: { volume: CRATE * CRATE, shape: 3 },
    linearDrag: 20,
    quadraticDrag: 60,
    angularDrag: 1,
    appearance: rgba(0.75, 0.6, 0.35),
  });
  crates.push(crate);
}

/** The water below the surface, as a polygon. */
function waterOf(world: PhysicsWorld, sea: FluidVolume): Point[] {
  const surface = Array.from({ length: 121 }, (_, i) => {
    const x = -30 + i / 2;
    return { x, y: surfaceHeight(sea, { x }, world.time) };
  });
  return [...surface, { x: 30, y: -40 }, { x: -30, y: -40 }];
}

export default defineExample({
  id: 'ch17-boats-on-waves',
  title: 'A boat on waves',
  chapter: 17,
  tags: ['buoyancy', 'waves', 'rotation', 'rigid body'],
  about:
    'The waves run, the water stays: each drop goes round in a circle, the smaller the deeper it is, and drifts on only slowly. A boat is lifted and tilted with the water. It rights itself as long as its metacentre, the point about which the push of the water swings, is above its centre of mass. The higher the lamp, the more slowly it rolls: when it rolls as slowly as the waves come, each wave tips it further.',
  duration: 40,
  parameters: {
    amplitude: { label: 'Height of the crests', unit: 'm', initial: 0.45, min: 0, max: 0.8 },
    length: { label: 'Wavelength', unit: 'm', initial: 20, min: 14, max: 60 },
    mast: { label: 'Lamp above the deck', unit: 'm', initial: 0.8, min: 0.3, max: 4 },
  },
  presets: [
    { label: 'Calm water', values: { amplitude: 0 } },
    { label: 'A long swell', values: { length: 60, amplitude: 0.8 } },
    { label: 'In time with the waves', values: { mast: 2.5 } },
  ],
  build(values: Values, options) {
    const sea = seaOf(values);
    const world = createPhysicsWorld({
      preset: rigidBodies,
      capacity: 64,
      precision: 'f64',
      forces: [
        uniformGravity({ y: -GRAVITY }),
        buoyancy(sea),
        polygonBuoyancy(sea, { shape: 2, vertices: CORNERS }),
        polygonBuoyancy(sea, { shape: 3, vertices: box(CRATE, CRATE) }),
        immersedDrag(sea),
        angularDrag(),
      ],
      seed: options.seed,
    });
    const boat = launchBoat(world, -4.5, 0.05, values);
    // To a weight on the bottom of the sea.
    const keel = placeOn(world, boat, { x: 0, y: KEEL });
    createJoint(world, distance({ b: boat, anchorA: ANCHOR, anchorB: keel, limits: { upper: 7 } }));
    const drops = DEPTHS.map((depth) => addDrop(world, depth, values));
    const crates: number[] = [];
    return {
      world,
      dt: 1 / 60,
      sea,
      boat,
      drops,
      crates,
      drop: (at: Point) => dropCrate(world, crates, at),
      angle: () => world.components.Rotation.angle[boat],
    };
  },
  picture({ world, sea, boat, drops }, { mast }) {
    return {
      view: VIEW,
      fills: [{ shape: () => waterOf(world, sea), color: COLORS.water, opacity: 0.45, inFront: true }],
      lines: [
        {
          from: () => placeOn(world, boat, { x: 0, y: DECK }),
          to: () => placeOn(world, boat, { x: 0, y: DECK + mast }),
        },
        { from: ANCHOR, to: () => placeOn(world, boat, { x: 0, y: KEEL }), color: COLORS.grey, width: 1 },
      ],
      trails: drops.map((body) => ({ body, length: 200 })),
    };
  },
  actions: {
    crate: {
      label: 'Drop a crate',
      about: 'drop a crate on the boat',
      key: ' ',
      press: ({ drop, world, boat }) => drop({ x: positionOf(world, boat).x, y: 4 }),
    },
  },
  pointer: {
    about: 'drop a crate there',
    press: ({ drop }, at) => drop(at),
  },
  plots: (plot) => [
    plot('Roll of the boat', 'angle, rad', { label: 'stepped', value: ({ angle }) => angle() }),
    plot(
      'Heights',
      'y, m',
      { label: 'boat', value: ({ world, boat }) => positionOf(world, boat).y },
      {
        label: 'surface at the boat',
        value: ({ world, sea, boat }) => surfaceHeight(sea, { x: positionOf(world, boat).x }, world.time),
      },
    ),
  ],
  checks: ({ at, largest }) => [
    // The sides of the hull slope, and water and joint damp the roll.
    {
      label: 'Period of a small roll on calm water',
      unit: 's',
      exact: ({ mast }) => rollPeriod(mast),
      tolerance: { relative: 0.01 },
      preset: 'Calm water',
      holds: ({ amplitude, mast }) => amplitude === 0 && metacentreOf(mast) > 0.1,
      at: { event: ({ angle }) => angle(), from: 1, to: 2 },
    },
    // Of the third order in the steepness k r of the circle.
    largest(
      4,
      'Height of the deepest drop’s circle, 2 a e^(k z)',
      { exact: (values) => 2 * orbitOf(DEEPEST, values), unit: 'm', relative: 0.01 },
      ({ world, drops }) => -DEEPEST - positionOf(world, drops[5]).y,
    ),
    at(
      40,
      'Where it has drifted by then: r² ω k of Stokes, and its circle',
      { exact: (values) => placeAfter(40, DEEPEST, values), unit: 'm', relative: 0.03 },
      ({ world, drops }) => positionOf(world, drops[5]).x,
    ),
  ],
  tryThis: [
    'Press on the picture to load the boat with crates.',
    'Choose “In time with the waves”: the boat turns over. With the lamp at 4 m it is safe again.',
    'Choose “A long swell”: the boat goes up and down with the water, and hardly tilts.',
    'Follow the white drops: the wave passes, and they come back almost to where they were.',
  ],
});
