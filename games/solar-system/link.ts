/** What the address of the page says after `#`: a date, a mission, a flight to watch, a body to follow, a speed of time. */
import { BODY_NAMES, type BodyName, EPOCH_2012 } from '@principia/scenes';
import { dayText, readDay } from './dates.ts';
import type { Burn } from './flight.ts';
import { missionOf } from './missions.ts';
import { DATES, type Opening } from './sim.ts';
import { RATES } from './solar-clock.ts';
import { WORDS } from './words.ts';

export interface Link extends Opening {
  readonly follow: BodyName;
  /** A sentence for each part that cannot be read. */
  readonly problems: readonly string[];
}

/** Burns of a link at most. */
const MAX_BURNS = 20;

/** @param hash as in `location.hash` */
export function readLink(hash: string): Link {
  const problems: string[] = [];
  const query = new URLSearchParams(hash.replace(/^#/, ''));
  const read = <T>(name: string, fallback: T, parse: (text: string) => T | undefined, wanted: string): T => {
    const text = query.get(name);
    if (text === null) return fallback;
    const value = parse(text);
    if (value === undefined) problems.push(WORDS.link.wrong(name, wanted, text));
    return value ?? fallback;
  };
  const { link } = WORDS;
  const mission = read('mission', '', (text) => missionOf(text)?.id, link.mission);
  return {
    date: read('date', EPOCH_2012, readDate, link.date(dayText(DATES.first), dayText(DATES.last))),
    rate: read('speed', RATES.initial, readRate, link.speed(RATES.min, RATES.max)),
    mission,
    burns: read('flight', [], readBurns, link.flight),
    follow: read('follow', 'sun', readBody, link.follow(BODY_NAMES.join(', '))),
    problems,
  };
}

/** The part of an address that repeats a flight. */
export function flightLink(mission: string, burns: readonly Burn[]): string {
  const parts = burns.map(([time, ...amounts]) => [time.toFixed(1), ...amounts].join('_'));
  return `#mission=${mission}&flight=${parts.join('~')}`;
}

function readDate(text: string): number | undefined {
  const date = readDay(text);
  return date !== undefined && date >= DATES.first && date <= DATES.last ? date : undefined;
}

function readRate(text: string): number | undefined {
  const rate = Number(text);
  return rate >= RATES.min && rate <= RATES.max ? rate : undefined;
}

function readBody(text: string): BodyName | undefined {
  return BODY_NAMES.find((name) => name === text);
}

function readBurns(text: string): readonly Burn[] | undefined {
  const burns = text
    .split('~')
    .map((part) => part.split('_').map((number) => (number === '' ? Number.NaN : Number(number))));
  const isBurn = (numbers: readonly number[]) =>
    numbers.length === 4 &&
    numbers.every(Number.isFinite) &&
    numbers[0] >= 0 &&
    numbers.slice(1).every((v) => Math.abs(v) < 50);
  if (burns.length > MAX_BURNS || !burns.every(isBurn)) return undefined;
  return burns.map(([time, forward, outward, north]) => [time, forward, outward, north]);
}
