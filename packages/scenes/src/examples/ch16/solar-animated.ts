import { rungeKutta4 } from '@principia/physics';
import { type BuildOptions, defineExample } from '../define-example.ts';
import type { CameraKey, Point } from '../picture.ts';
import { lengthOf } from '../support/read.ts';
import { aboutSun, DAYS, errorKm, INNER_CAMERA, innerPicture, type SolarRun, system2012 } from '../support/solar.ts';

/** Distance from the Sun in the ecliptic. */
const inPlane = ({ x, y }: Point) => lengthOf({ x, y });

/** From above, then down to the Earth as Venus passes between it and the Sun, and up again. */
const FLIGHT: readonly CameraKey[] = [
  { time: 0, ...INNER_CAMERA },
  { time: 8, eye: { x: 0, y: -540, z: 430 }, target: { x: 0, y: -20, z: 0 } },
  { time: 15.7, eye: { x: -25, y: -440, z: 115 }, target: { x: -25, y: -120, z: 0 } },
  { time: 20, eye: { x: 60, y: -480, z: 170 }, target: { x: 60, y: -80, z: 0 } },
  { time: 28, eye: { x: 0, y: -560, z: 500 }, target: { x: 0, y: 0, z: 0 } },
  { time: 36.5, ...INNER_CAMERA },
];

/** Days until the last stored position before a year is over. */
const LAST = 360;

export default defineExample({
  id: 'ch16-solar-animated',
  title: 'A year of the inner planets',
  chapter: 16,
  tags: ['3D', 'gravity', 'planets'],
  about:
    'Each step of the simulation is an hour, and 240 of them pass in each second. The plot counts the days, so one can look up where a planet really was: Venus passed between Earth and Sun on the 6th of June 2012, when both stand in one line as seen from the Sun. The camera comes down to see it, unless you take it into your own hands.',
  dimensions: 3,
  duration: 36.5,
  ends: true,
  parameters: {},
  build(_: object, { integrator = rungeKutta4 }: BuildOptions) {
    const run = system2012({ integrator });
    // Twice the area of the triangle of Sun, Venus and Earth over the product of their distances: the sine of the angle.
    const between = () => {
      const [venus, earth] = [aboutSun(run, 'venus').r, aboutSun(run, 'earth').r];
      return (venus.x * earth.y - venus.y * earth.x) / (inPlane(venus) * inPlane(earth));
    };
    return { ...run, between };
  },
  picture: (run) => ({
    ...innerPicture(run),
    cameraPath: FLIGHT,
    lines: [{ from: () => aboutSun(run, 'venus').r, to: () => aboutSun(run, 'earth').r, width: 1 }],
  }),
  plots: [
    {
      title: 'Angle between Venus and Earth, its sine',
      x: { label: 't, days', value: ({ world }) => DAYS * world.time },
      y: { label: 'sine' },
      series: [{ label: 'sine', value: ({ between }) => between() }],
    },
  ],
  checks: ({ at }) => [
    ...(['mercury', 'venus', 'earth', 'mars'] as const).map((name) =>
      at(
        LAST / DAYS,
        `Distance of ${name[0].toUpperCase()}${name.slice(1)} from JPL’s position after 360 days`,
        { exact: 0, unit: 'km', absolute: 1 },
        (run: SolarRun) => errorKm(run, name, LAST),
      ),
    ),
    {
      label: 'Venus passes the Earth, 6 June 2012, 01:10',
      unit: 'd',
      exact: 157.05,
      // The conjunction in ecliptic longitude; light takes another five minutes.
      tolerance: { absolute: 0.02 },
      at: {
        event: ({ world, between }: SolarRun & { between(): number }) => (world.time > 12 ? -between() : -1),
        count: 1,
      },
      measure: ({ world }) => DAYS * world.time,
    },
  ],
  tryThis: [
    'Follow the line from Venus to the Earth: it is shortest when Venus passes.',
    'Drag the picture to take the camera; F gives it back to its flight.',
  ],
});
