// Events of the sky against published ones: transits by Espenak (NASA, Seven Century Catalogs of transits), times of least
// distance in UTC as seen from the Earth's centre, and angles in arc seconds.
import { describe, expect, it } from 'vitest';
import { solarState } from './build.ts';
import { type SkyEvent, SkyEventFinder } from './sky-events.ts';
import { EPOCH_2012 } from './states-2012.ts';

const ARC_SECOND = Math.PI / 180 / 3600;
const MINUTE = 1 / 1440;

/** Julian date of a UTC, as TDB: 64 to 73 s ahead between 2000 and 2035. */
const at = (utc: string) => Date.parse(`${utc}Z`) / 86_400_000 + 2_440_587.5 + 68 / 86_400;

function eventsUntil(year: number, finder = new SkyEventFinder()): SkyEvent[] {
  const events: SkyEvent[] = [];
  while (finder.julianDate < at(`${year}-01-01T00:00`)) events.push(...finder.advance());
  return events;
}

const events = eventsUntil(2034);
const select = (kind: SkyEvent['kind'], body: string, other?: string) =>
  events.filter((event) => event.kind === kind && event.body === body && event.other === other);

describe('transits', () => {
  // Minutes: the least distance is flat, and tables round to one; the Sun's radius has 0.1″ of uncertainty.
  it.each([
    ['mercury', '2003-05-07T07:52', 708],
    ['venus', '2004-06-08T08:20', 627],
    ['mercury', '2006-11-08T21:41', 423],
    ['venus', '2012-06-06T01:30', 554],
    ['mercury', '2016-05-09T14:57', 319],
    ['mercury', '2019-11-11T15:20', 76],
    ['mercury', '2032-11-13T08:54', 572],
  ])('%s, %s', (body, utc, arcSeconds) => {
    const event = select('transit', body).find(({ julianDate }) => Math.abs(julianDate - at(utc)) < 1);
    expect(event, 'found').toBeDefined();
    expect(Math.abs((event?.julianDate ?? 0) - at(utc)) / MINUTE).toBeLessThan(2);
    expect(Math.abs((event?.separation ?? 0) / ARC_SECOND - arcSeconds)).toBeLessThan(2);
  });

  it('are no more than those, from 2000 to 2034', () => {
    expect(select('transit', 'venus')).toHaveLength(2);
    expect(select('transit', 'mercury')).toHaveLength(5);
  });
});

describe('conjunctions and oppositions', () => {
  it('finds the great conjunctions of Jupiter and Saturn, 6′ apart in 2020', () => {
    const found = select('meeting', 'jupiter', 'saturn');
    expect(found).toHaveLength(2);
    expect(Math.abs(found[0].julianDate - at('2000-05-28T16:00'))).toBeLessThan(0.2);
    expect(Math.abs(found[1].julianDate - at('2020-12-21T18:20'))).toBeLessThan(30 * MINUTE);
    expect(Math.abs(found[1].separation / ARC_SECOND / 60 - 6.1)).toBeLessThan(0.1);
  });

  it('finds the oppositions of Mars, of which that of 2003 was the closest for long', () => {
    const found = select('opposition', 'mars');
    const days = ['2001-06-13', '2003-08-28', '2005-11-07', '2007-12-24', '2010-01-29', '2012-03-03', '2014-04-08'];
    days.push('2016-05-22', '2018-07-27', '2020-10-13', '2022-12-08', '2025-01-16');
    const utc = (event: SkyEvent) =>
      new Date((event.julianDate - 68 / 86_400 - 2_440_587.5) * 86_400_000).toISOString().slice(0, 10);
    expect(found.slice(0, days.length).map(utc)).toEqual(days);
    const closest = Math.min(...found.map(({ distance }) => distance));
    expect(found[1].distance).toBe(closest);
    // The least distance of 55.758 million km was a day and a half before.
    expect(closest / 1e6).toBeCloseTo(55.8, 1);
  });

  it('passes each planet by its synodic period', () => {
    for (const [body, days] of [
      ['mercury', 115.88],
      ['venus', 583.92],
    ] as const) {
      const found = [...select('inferior', body), ...select('transit', body)].map(({ julianDate }) => julianDate);
      found.sort((a, b) => a - b);
      const mean = (found[found.length - 1] - found[0]) / (found.length - 1);
      // The ends are off their means by the ellipses: up to 10 days for Mercury over 34 years, 4 for Venus.
      expect(Math.abs(mean / days - 1)).toBeLessThan(2 / found.length / 10);
    }
  });
});

it('begins at any date, without the Moon as well, where transits shift by the parallax of the Earth’s swing', () => {
  const finder = new SkyEventFinder(false);
  finder.begin(EPOCH_2012, (name) => solarState(name, 2012, false));
  const transit = eventsUntil(2013, finder).find(({ kind }) => kind === 'transit');
  // 4670 km at the distances of Venus and of the Sun: 22″ − 6″ across, which Venus takes 4 minutes for.
  expect(Math.abs((transit?.julianDate ?? 0) - at('2012-06-06T01:30')) / MINUTE).toBeLessThan(6);
  expect(Math.abs((transit?.separation ?? 0) / ARC_SECOND - 554)).toBeLessThan(17);
});
