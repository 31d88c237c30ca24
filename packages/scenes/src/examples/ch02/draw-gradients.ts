import { defineExample, type ValuesOf } from '../define-example.ts';
import type { Color, Fill } from '../picture.ts';
import { emptyWorld } from '../support/read.ts';

type Rgb = readonly [red: number, green: number, blue: number];

const [WHITE, BLUE, RED]: Rgb[] = [
  [255, 255, 255],
  [0, 0, 255],
  [255, 0, 0],
];
const HEIGHT = 500;
const DISC = { x: 350, y: 250, inner: 5, outer: 50 };

/** The colour at a fraction of the way from one to another. */
const mix = (a: Rgb, b: Rgb, t: number): Rgb => [0, 1, 2].map((c) => a[c] + t * (b[c] - a[c])) as unknown as Rgb;
const toColor = ([r, g, b]: Rgb): Color => (Math.round(r) << 16) | (Math.round(g) << 8) | Math.round(b);

export default defineExample({
  id: 'ch02-draw-gradients',
  title: 'From one colour to another',
  chapter: 2,
  tags: ['drawing', 'colour'],
  about:
    'A gradient is many stripes, each of a slightly different colour: red, green and blue are each mixed in proportion to the distance. Half-way between white and blue all three are half-way. For a glow the stripes are rings, from the outside in. With few stripes one sees how it is made.',
  duration: 10,
  parameters: { stripes: { label: 'Stripes', initial: 101, min: 3, max: 101, integer: true } },
  presets: [{ label: 'Nine stripes', values: { stripes: 9 } }],
  build({ stripes }: ValuesOf<'stripes'>) {
    const world = emptyWorld();
    /** Colours at the middle of each stripe. */
    const ramp = (a: Rgb, b: Rgb) => Array.from({ length: stripes }, (_, i) => mix(a, b, (i + 0.5) / stripes));
    const y = () => (50 * world.time) % HEIGHT;
    return { world, dt: 1 / 60, sky: ramp(WHITE, BLUE), glow: ramp(WHITE, RED), y };
  },
  picture({ sky, glow, y }, { stripes }) {
    const high = HEIGHT / stripes;
    const { x, y: middle, inner, outer } = DISC;
    const rings = glow.map((color, i): Fill => {
      const radius = inner + ((outer - inner) * (i + 1)) / stripes;
      return { shape: { centre: { x, y: middle }, radius }, color: toColor(color) };
    });
    return {
      yDown: true,
      view: { minX: 0, maxX: 700, minY: 0, maxY: HEIGHT },
      fills: [
        ...sky.map((color, i): Fill => {
          return { shape: { minX: 0, maxX: 700, minY: i * high, maxY: (i + 1) * high }, color: toColor(color) };
        }),
        ...rings.reverse(),
        { shape: { centre: { x, y: middle }, radius: inner }, color: toColor(WHITE) },
      ],
      dots: [{ at: () => ({ x: 120, y: y() }), radius: 8, color: 0x10142a }],
      labels: [
        {
          at: () => ({ x: 140, y: y() + 5 }),
          text: () =>
            `rgb(${mix(WHITE, BLUE, y() / HEIGHT)
              .map(Math.round)
              .join(', ')})`,
          color: 0x10142a,
        },
      ],
    };
  },
  plots: [
    {
      title: 'The colour beside the dot',
      x: { label: 'y, px', value: ({ y }) => y() },
      y: { label: '0 to 255' },
      series: [
        { label: 'red', value: ({ y }) => mix(WHITE, BLUE, y() / HEIGHT)[0] },
        { label: 'blue', value: ({ y }) => mix(WHITE, BLUE, y() / HEIGHT)[2] },
      ],
    },
  ],
  checks: ({ at }) => [
    at(0, 'Red of the stripe at half height', { exact: 255 / 2, absolute: 1e-9 }, ({ sky }) => sky[50][0]),
    at(0, 'Blue of the stripe at half height', { exact: 255, absolute: 0 }, ({ sky }) => sky[50][2]),
    at(0, 'Green of the glow half-way from 5 to 50 px', { exact: 255 / 2, absolute: 1e-9 }, ({ glow }) => glow[50][1]),
  ],
  tryThis: ['Choose “Nine stripes”: the eye sees an edge at each, even darker than it is.'],
});
