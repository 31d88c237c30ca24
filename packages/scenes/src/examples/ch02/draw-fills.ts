import { cos, sin } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { areaOf } from '../support/outline.ts';
import { distanceBetween, emptyWorld } from '../support/read.ts';

const [A, B] = [
  { x: 50, y: 100 },
  { x: 250, y: 400 },
];
const RECTANGLE = [
  { x: 320, y: 80 },
  { x: 470, y: 80 },
  { x: 470, y: 180 },
  { x: 320, y: 180 },
];
/** A rectangle of which only the outline is drawn, 2 px wide. */
const OUTLINE = [
  { x: 540, y: 60 },
  { x: 640, y: 60 },
  { x: 640, y: 210 },
  { x: 540, y: 210 },
];

export default defineExample({
  id: 'ch02-draw-fills',
  title: 'Lines, boxes and almost circles',
  chapter: 2,
  tags: ['drawing', 'geometry'],
  about:
    'A screen knows no circles: what looks like one is a polygon with many short sides. Choose the number of corners and watch the area of the disc grow towards π r². The other shapes are simpler: a line, whose length follows from Pythagoras, and boxes, filled or not. What is drawn later lies on top.',
  duration: 6,
  parameters: { corners: { label: 'Corners of the disc', initial: 48, min: 3, max: 100, integer: true } },
  presets: [{ label: 'A hexagon', values: { corners: 6 } }],
  build({ corners }: ValuesOf<'corners'>) {
    const world = emptyWorld();
    const on = (angle: number) => ({ x: 470 + 100 * cos(angle), y: 330 + 100 * sin(angle) });
    const disc = pointsOf(on, 0, 2 * Math.PI, corners).slice(0, -1);
    const runner = () => {
      const share = (world.time % 6) / 6;
      const i = Math.floor(share * corners);
      const [a, b, part] = [disc[i % corners], disc[(i + 1) % corners], share * corners - i];
      return { x: a.x + part * (b.x - a.x), y: a.y + part * (b.y - a.y) };
    };
    return { world, dt: 1 / 60, disc, runner };
  },
  picture: ({ disc, runner }) => ({
    yDown: true,
    view: { minX: 0, maxX: 700, minY: 20, maxY: 480 },
    fills: [
      { shape: RECTANGLE, color: COLORS.green },
      { shape: disc, color: COLORS.blue },
      { shape: { minX: 540, maxX: 660, minY: 300, maxY: 420 }, color: COLORS.red },
    ],
    lines: [
      { from: A, to: B, color: COLORS.blue },
      ...OUTLINE.map((from, i) => ({ from, to: OUTLINE[(i + 1) % 4], color: COLORS.blue })),
    ],
    dots: [{ at: runner }],
    labels: [
      { at: { x: 60, y: 420 }, text: `${distanceBetween(A, B).toFixed(1)} px long` },
      { at: { x: 320, y: 70 }, text: `${areaOf(RECTANGLE)} px²` },
      { at: { x: 548, y: 140 }, text: `${areaOf(OUTLINE)} px²` },
      { at: { x: 400, y: 460 }, text: `${areaOf(disc).toFixed(0)} px²` },
    ],
  }),
  plots: [],
  checks: ({ at }) => [
    at(
      0,
      'Length of the line, √(200² + 300²)',
      { exact: Math.sqrt(200 * 200 + 300 * 300), unit: 'px', absolute: 1e-9 },
      () => distanceBetween(A, B),
    ),
    at(0, 'Area of the green box', { exact: 15000, unit: 'px²', absolute: 0 }, () => areaOf(RECTANGLE)),
    at(0, 'Area within the blue outline', { exact: 15000, unit: 'px²', absolute: 0 }, () => areaOf(OUTLINE)),
    at(0, 'Area of the disc of 48 corners, π r²', { exact: 10000 * Math.PI, unit: 'px²', relative: 0.01 }, ({ disc }) =>
      areaOf(disc),
    ),
  ],
  tryThis: [
    'Take six corners: 17 % of the area is missing. With twelve it is only 5 %.',
    'Look where the red box and the disc overlap: the one that was drawn last is in front.',
  ],
});
