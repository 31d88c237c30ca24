import { circle, createPhysicsWorld, rgba, rigidBodies, spawnCompound } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { placeOn } from '../support/outline.ts';

const [BODY, HEAD] = [20, 10];

export default defineExample({
  id: 'ch08-stickman',
  title: 'A man made of two discs',
  chapter: 8,
  tags: ['drawing', 'components'],
  about:
    'Two discs are enough to see a man: a body, and a head on it. Together they are one body, whose centre of mass lies between them, nearer to the larger disc. Let him turn somersaults: that point alone stays where it is. “A bungee jump” ties him to a cord.',
  duration: 5,
  parameters: {
    spin: { label: 'Angular velocity', unit: 'rad/s', initial: 2, min: -6, max: 6 },
    head: { label: 'Radius of the head', unit: 'px', initial: HEAD, min: 5, max: 20 },
  },
  presets: [{ label: 'Big head', values: { head: 20 } }],
  build({ spin, head }: ValuesOf<'spin' | 'head'>) {
    const world = createPhysicsWorld({ preset: rigidBodies, capacity: 8 });
    const skin = rgba(1, 0.75, 0.5);
    const { body } = spawnCompound(world, {
      velocity: {},
      angularVelocity: spin,
      parts: [
        { shape: circle(BODY), density: 1, appearance: rgba(0.43, 0.72, 1) },
        { shape: circle(head), y: BODY + head, density: 1, appearance: skin },
      ],
    });
    /** Height of the centre of mass over the middle of the body: its place, as the middle was put into the origin. */
    const centre = world.components.Position.y[body];
    const place = () => ({ x: world.components.Position.x[body], y: world.components.Position.y[body] });
    return { world, dt: 1 / 60, body, centre, place };
  },
  picture({ world, body, centre, place }) {
    const limb = (x1: number, y1: number, x2: number, y2: number) => ({
      from: () => placeOn(world, body, { x: x1, y: y1 - centre }),
      to: () => placeOn(world, body, { x: x2, y: y2 - centre }),
      color: COLORS.blue,
      width: 4,
    });
    return {
      view: { minX: -110, maxX: 110, minY: -80, maxY: 95 },
      lines: [limb(-17, 10, -38, 24), limb(17, 10, 38, 24), limb(-10, -17, -16, -48), limb(10, -17, 16, -48)],
      dots: [{ at: place, radius: 4, color: COLORS.red }],
    };
  },
  plots: [],
  checks: ({ at }) => [
    at(
      0,
      'Centre of mass over the middle of the body, (R + r) r²/(R² + r²)',
      { exact: ({ head }) => ((BODY + head) * head * head) / (BODY * BODY + head * head), unit: 'px', relative: 1e-12 },
      ({ centre }) => centre,
    ),
    at(
      5,
      'Height of the centre of mass after 5 s of somersaults',
      { exact: 6, unit: 'px', absolute: 1e-9 },
      ({ place }) => place().y,
    ),
  ],
  tryThis: ['Choose “Big head”: now the centre of mass is at his neck.'],
});
