import { choiceOf, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type ViewBox } from '../picture.ts';
import { emptyWorld } from '../support/read.ts';

const GREEN: ViewBox = { minX: 50, maxX: 300, minY: 50, maxY: 350 };

/** Area that two boxes share. */
function overlap(a: ViewBox, b: ViewBox): number {
  const width = Math.min(a.maxX, b.maxX) - Math.max(a.minX, b.minX);
  const height = Math.min(a.maxY, b.maxY) - Math.max(a.minY, b.minY);
  return Math.max(0, width) * Math.max(0, height);
}

export default defineExample({
  id: 'ch02-canvas-layers',
  title: 'What is drawn last lies on top',
  chapter: 2,
  tags: ['drawing', 'geometry'],
  about:
    'Two sheets, one over the other: where they overlap only the one is seen that was drawn last. That is all there is to layers. Draw what is far away first, and what is near last, and a flat picture looks deep.',
  duration: 2,
  parameters: {
    last: choiceOf('Drawn last', ['red', 'green']),
    left: { label: 'Left side of the red sheet', unit: 'px', initial: 250, min: 0, max: 500 },
  },
  presets: [{ label: 'Green on top', values: { last: 1 } }],
  build({ left }: ValuesOf<'last' | 'left'>) {
    const red = { minX: left, maxX: left + 200, minY: 250, maxY: 400 };
    return { world: emptyWorld(), dt: 1 / 60, red, shared: () => overlap(GREEN, red) };
  },
  picture({ red, shared }, { last }) {
    const fills = [
      { shape: GREEN, color: COLORS.green },
      { shape: red, color: COLORS.red },
    ];
    return {
      yDown: true,
      view: { minX: 0, maxX: 700, minY: 0, maxY: 500 },
      fills: last === 0 ? fills : fills.reverse(),
      labels: [{ at: { x: 60, y: 450 }, text: `${shared().toFixed(0)} px² are covered twice` }],
    };
  },
  plots: [],
  checks: ({ at }) => [
    at(0, 'Area that is covered twice, 50 by 100 px', { exact: 5000, unit: 'px²', absolute: 0 }, ({ shared }) =>
      shared(),
    ),
  ],
  tryThis: ['Choose “Green on top”: nothing has moved, and yet the red sheet now lies behind.'],
});
