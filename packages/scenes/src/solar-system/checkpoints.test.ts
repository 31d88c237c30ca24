import { rungeKutta4 } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { buildSolarSystem } from './build.ts';
import { checkpoints, errorsIn2012 } from './checkpoints.ts';
import { advanceTo, DAY } from './errors.ts';
import { positions2012 } from './positions-2012.ts';
import { EPOCH } from './states.ts';
import { EPOCH_2012 } from './states-2012.ts';

const last = positions2012()[61];

describe('from JPL’s state of 2012', () => {
  test('the start is the first row', () => {
    const system = buildSolarSystem({ epoch: 2012 });
    // Rows are rounded to 10 m, states to less than a metre.
    for (const error of Object.values(errorsIn2012(system, positions2012()[0]))) expect(error).toBeLessThan(0.01);
  });

  test.each([
    ['Gauss-Radau', {}],
    ['Runge-Kutta 4', { integrator: rungeKutta4 }],
  ])(
    'after 366 days by %s the planets are within a kilometre and the Moon within 40',
    (_, options) => {
      const system = buildSolarSystem({ epoch: 2012, ...options });
      advanceTo(system.world, last.days * DAY, 'integrator' in options ? DAY / 24 : 32 * DAY);
      const { moon, ...planets } = errorsIn2012(system, last);
      expect(Object.keys(planets)).toEqual(['mercury', 'venus', 'earth', 'mars']);
      for (const [name, error] of Object.entries(planets)) expect(error, name).toBeLessThan(1);
      expect(moon).toBeLessThan(40);
    },
    30_000,
  );

  test('Earth and Moon as one body are where their centre of mass is', () => {
    const system = buildSolarSystem({ epoch: 2012, moon: false });
    expect(errorsIn2012(system, positions2012()[0]).earth).toBeLessThan(0.01);
  });
});

test('the state of 2000 reaches the first row of 2012 within kilometres', () => {
  const system = buildSolarSystem();
  advanceTo(system.world, (EPOCH_2012 - EPOCH) * DAY, 32 * DAY);
  const { moon, ...planets } = errorsIn2012(system, positions2012()[0]);
  for (const [name, error] of Object.entries(planets)) expect(error, name).toBeLessThan(5);
  expect(moon).toBeLessThan(250);
}, 30_000);

test('checkpoints are in order of time and judge a new system', () => {
  const dates = checkpoints().map(({ julianDate }) => julianDate);
  expect(dates).toEqual([...dates].sort((a, b) => a - b));
  expect(dates).toContain(EPOCH_2012);
  const start = checkpoints().find(({ julianDate }) => julianDate === EPOCH_2012);
  expect(start?.errors(buildSolarSystem({ epoch: 2012 })).earth).toBeLessThan(0.01);
});
