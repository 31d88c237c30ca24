import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Fill } from '../picture.ts';
import { emptyWorld } from '../support/read.ts';

const YELLOW = [255, 255, 0] as const;

/** What is seen of a channel if a colour of this opacity lies over another colour. */
const over = (channel: number, below: number, opacity: number) => opacity * channel + (1 - opacity) * below;

export default defineExample({
  id: 'ch12-spark',
  title: 'A spark that one can see through',
  chapter: 12,
  tags: ['particles', 'colour', 'drawing'],
  about:
    'A spark is a small disc with a colour and an opacity. At an opacity of a half, half of what is seen is the spark and half is what lies behind it. Sparks that overlap cover more and more: n of them let (1 − opacity)ⁿ of the background through. Fading is nothing else than an opacity that goes down to zero.',
  duration: 6,
  parameters: {
    opacity: { label: 'Opacity', initial: 0.5, min: 0, max: 1 },
    sparks: { label: 'Sparks in the pile', initial: 4, min: 1, max: 10, integer: true },
  },
  presets: [{ label: 'Faint, but many', values: { opacity: 0.15, sparks: 10 } }],
  build({ opacity, sparks }: ValuesOf<'opacity' | 'sparks'>) {
    const world = emptyWorld();
    const blended = YELLOW.map((channel) => over(channel, 0, opacity));
    let pile = 0;
    for (let i = 0; i < sparks; i++) pile = over(255, pile, opacity);
    const fade = () => Math.max(0, opacity * (1 - world.time / 6));
    return { world, dt: 1 / 60, blended, pile, fade };
  },
  picture({ blended, pile, fade }, { opacity, sparks }) {
    const disc = (x: number, radius: number): Fill => {
      return { shape: { centre: { x, y: 100 }, radius }, color: 0xffff00, opacity };
    };
    return {
      view: { minX: 0, maxX: 400, minY: 0, maxY: 200 },
      fills: [
        { shape: { minX: -900, maxX: 1300, minY: -900, maxY: 1100 }, color: 0x000000 },
        { shape: { minX: 40, maxX: 120, minY: 90, maxY: 110 }, color: COLORS.blue },
        disc(80, 45),
        ...Array.from({ length: sparks }, (_, i) => disc(250 + 12 * i, 40)),
      ],
      labels: [
        { at: { x: 30, y: 35 }, text: `one: rgb(${blended.map((c) => c.toFixed(1)).join(', ')})` },
        { at: { x: 230, y: 35 }, text: `pile: ${((100 * pile) / 255).toFixed(0)} % covered` },
        { at: { x: 30, y: 180 }, text: () => `fading: ${fade().toFixed(2)}`, color: COLORS.grey },
      ],
    };
  },
  plots: (plot) => [
    plot('Opacity of a spark that fades', 'opacity', { label: 'opacity', value: ({ fade }) => fade() }),
  ],
  checks: ({ at }) => [
    at(0, 'Red of yellow at an opacity of 0.5 over black', { exact: 127.5, absolute: 2 }, ({ blended }) => blended[0]),
    at(0, 'Blue of it', { exact: 0, absolute: 2 }, ({ blended }) => blended[2]),
    at(
      0,
      'What a pile of n covers, 1 − (1 − opacity)ⁿ',
      { exact: 1 - 0.5 ** 4, absolute: 1e-12 },
      ({ pile }) => pile / 255,
    ),
  ],
  tryThis: ['Choose “Faint, but many”: ten sparks that one hardly sees make a bright heap. So flames are painted.'],
});
