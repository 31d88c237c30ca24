import { energy } from '@principia/physics';
import { type BuildOptions, choiceOf, defineExample, type ValuesOf } from '../define-example.ts';
import { type ThreeBodyRun, threeBodies, threeBodyPicture } from '../support/three-bodies.ts';

type Values = ValuesOf<'dance' | 'nudge'>;

/** Velocities of the outer stars and periods: Šuvakov and Dmitrašinović, Phys. Rev. Lett. 110, 114301 (2013), table I. */
const DANCES = [
  { name: 'Butterfly', x: 0.30689, y: 0.12551, period: 6.2356 },
  { name: 'Moth', x: 0.46444, y: 0.39606, period: 14.8939 },
  { name: 'Goggles', x: 0.0833, y: 0.12789, period: 10.4668 },
  { name: 'Dragonfly', x: 0.08058, y: 0.58884, period: 21.271 },
  { name: 'Yin-yang', x: 0.51394, y: 0.30474, period: 17.3284 },
] as const;

export default defineExample({
  id: 'ch17-three-body-dances',
  title: 'The butterfly, the moth and the goggles',
  chapter: 17,
  tags: ['gravity', 'orbit', 'three bodies', 'chaos'],
  about:
    'For three hundred years three families of periodic motions of three stars were known. In 2013 two physicists let a computer search, and found thirteen new ones. All start in the same way: three equal stars in a row, the middle one moving against the other two, and all depends on the direction and the speed.',
  duration: 22,
  parameters: {
    dance: choiceOf(
      'Dance',
      DANCES.map(({ name }) => name),
    ),
    nudge: { label: 'Nudge of a star', unit: 'm', initial: 0, min: 0, max: 0.05 },
  },
  presets: DANCES.map(({ name }, dance) => ({ label: name, values: { dance } })),
  build({ dance, nudge }: Values, { integrator }: BuildOptions) {
    const { x, y, period } = DANCES[dance];
    return threeBodies(
      {
        places: [
          { x: -1, y: 0 },
          { x: 1, y: 0 },
          { x: 0, y: 0 },
        ],
        velocities: [
          { x, y },
          { x, y },
          { x: -2 * x, y: -2 * y },
        ],
        period,
      },
      nudge,
      integrator,
    );
  },
  picture: (run, { dance }) => threeBodyPicture(run, 3, 2, DANCES[dance].period),
  plots: (plot) => [
    plot(
      'Energies',
      'energy, J',
      { label: 'kinetic', value: ({ world }) => energy(world).kinetic },
      { label: 'total', value: ({ world }) => energy(world).total },
    ),
  ],
  checks: ({ at }) => [
    ...DANCES.map(({ name, period }) => ({
      label: `All are back where they started after ${period} s, off by`,
      unit: 'm',
      exact: 0,
      // The start is published to five digits, and a dance magnifies what is missing up to a thousandfold.
      tolerance: { absolute: 5e-3 },
      at: { time: period },
      measure: ({ offStart }: ThreeBodyRun) => offStart(),
      preset: name,
    })),
    at(
      20,
      'Change of the energy, as a fraction',
      { exact: 0, absolute: 1e-11 },
      ({ world, startEnergy }) => energy(world).total / startEnergy - 1,
    ),
  ],
  tryThis: [
    'Let the butterfly go on: its wings turn slowly, because five digits of its start are not enough. More digits are in the literature.',
    'Nudge a star by a centimetre: the moth, the goggles and the yin-yang only wobble. In the butterfly and the dragonfly two stars soon meet so closely that points would have to be balls.',
    'Compare integrators with ghosts: the stars pass each other closely, where a fixed step is too long.',
  ],
});
