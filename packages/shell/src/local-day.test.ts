import { afterEach, expect, it } from 'vitest';
import { dayOf } from './local-day.ts';

const { TZ } = process.env;

afterEach(() => {
  if (TZ === undefined) delete process.env.TZ;
  else process.env.TZ = TZ;
});

it.each([
  ['Asia/Tokyo', '2026-11-30'],
  ['Europe/Berlin', '2026-11-29'],
  ['America/New_York', '2026-11-29'],
])('is the date on the calendar in %s', (zone, day) => {
  process.env.TZ = zone;
  // Half past midnight in Tokyo.
  expect(dayOf(new Date('2026-11-29T15:30:00Z'))).toBe(day);
});
