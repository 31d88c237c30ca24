/** The challenge of the day: everybody who plays on the same date has the same holes. */
import { dayOf } from '@principia/shell';

/** The date with hyphens at which no line breaks. */
export const unbroken = (day: string): string => day.replaceAll('-', '\u2011');

/** The seed of a day: its date as a number, such as 20261123. */
export function seedOf(day: string): number {
  return Number(day.replaceAll('-', ''));
}

/** The day of a seed; undefined for a seed that is no date since 2026. */
export function dayOfSeed(seed: number): string | undefined {
  const [, year, month, date] = /^(\d{4})(\d\d)(\d\d)$/.exec(String(seed)) ?? [];
  if (year === undefined || Number(year) < 2026) return undefined;
  const day = `${year}-${month}-${date}`;
  const time = new Date(`${day}T12:00:00`);
  return Number.isNaN(time.getTime()) || dayOf(time) !== day ? undefined : day;
}
