import { EPOCH_2012 } from '@principia/scenes';
import { expect, test } from 'vitest';
import { dayText, julianDate, readDay, timeText } from './dates.ts';
import { flightLink, readLink } from './link.ts';

test('an empty address is the beginning of 2012', () => {
  expect(readLink('')).toMatchObject({ date: EPOCH_2012, mission: '', burns: [], follow: 'sun', problems: [] });
});

test('a flight comes back from its link', () => {
  const burns = [
    [0, 3.1234, -0.5, 0.0001],
    [8640000.5, 0, 0.0002, -1],
  ] as const;
  expect(readLink(flightLink('mars', burns))).toMatchObject({ mission: 'mars', burns, problems: [] });
});

test('whatever cannot be read is named, and the rest counts', () => {
  const link = readLink('#date=2012-02-30&mission=pluto&follow=mars&flight=1_2&speed=-3');
  expect(link.problems).toHaveLength(4);
  expect(link).toMatchObject({ date: EPOCH_2012, mission: '', burns: [], follow: 'mars' });
  expect(readLink('#date=1492-10-12').problems[0]).toContain('1900-01-01 to 2100-01-01');
});

test('Julian dates and the calendar agree', () => {
  expect(julianDate(2000, 1, 1)).toBe(2451544.5);
  expect(julianDate(2012, 1, 1)).toBe(EPOCH_2012);
  for (const day of ['1900-03-01', '1969-07-20', '2000-02-29', '2012-12-31', '2049-12-31']) {
    expect(dayText(readDay(day) as number)).toBe(day);
  }
  expect(readDay('2100-02-29')).toBeUndefined();
  expect([dayText(2451545), timeText(2451545)]).toEqual(['2000-01-01', '12:00']);
  expect(timeText(2451544.5 + 18 / 24 + 5 / 1440)).toBe('18:05');
});
