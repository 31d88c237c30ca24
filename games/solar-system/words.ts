/** The text of the game, and how it writes numbers. */
import type { BodyName } from '@principia/scenes';
import { LOOKS } from './bodies.ts';
import type { Mission } from './missions.ts';
import type { Limit } from './solar-clock.ts';

export const WORDS = {
  title: 'Solar system',
  welcome: 'Tap a planet to follow it, slide time faster – or fly a mission:',
  endMission: 'End mission',
  launch: 'Launch',
  burn: 'Burn',
  aiming: 'Aiming…',
  wait: (days: number) => `Wait ${days} day${days === 1 ? '' : 's'}`,
  accuracy: 'Against JPL’s ephemeris DE421',
  noReference:
    'JPL’s positions are stored for 2012, and for dates of 2000, 2001, 2010 and 2050: let time pass one of them.',
  forward: 'Forward',
  outward: 'Outward',
  north: 'North',
  today: 'Today',
  travelling: (days: number) => `Computing ${Math.ceil(days / 365.25)} year${days > 365.25 ? 's' : ''} of all orbits…`,
  tryIt: 'Fly it yourself',
  passBehind: (name: BodyName) => `Pass behind ${label(name)}`,
  passBefore: (name: BodyName) => `Pass before ${label(name)}`,
  reach: (name: BodyName) => `Reach ${label(name)}`,
  passed: (name: BodyName, distance: string) => `Passed ${label(name)} at ${distance}.`,
  overBudget: (budget: number) => `More than the ${budget} km/s of this mission`,
  aimFailed: 'No way found from here. Change the sliders a little, or wait some days.',
} as const;

export const label = (name: BodyName): string =>
  name === 'sun' || name === 'moon' ? `the ${LOOKS[name].label}` : LOOKS[name].label;

interface MissionWords {
  readonly title: string;
  readonly goal: string;
  readonly hint: string;
}

export const MISSION_WORDS: Readonly<Record<string, MissionWords>> = {
  mars: {
    title: 'To Mars',
    goal: 'Come within 1 million km of Mars.',
    hint: 'Slide until the dashed path meets ◎, where Mars will be – or let “Reach Mars” do the last bit.',
  },
  mercury: {
    title: 'Fall to Mercury',
    goal: 'Come within 2 million km of Mercury. Venus must brake you: the tank is too small without it.',
    hint: 'Pass before Venus, and its gravity takes speed from you; then reach for Mercury.',
  },
  saturn: {
    title: 'Jupiter slingshot',
    goal: 'Swing by Jupiter to Saturn, within 5 million km, in the autumn of the Voyagers.',
    hint: 'Pass behind Jupiter, and it drags you along on its way; then reach for Saturn.',
  },
};

const LIMITS: Readonly<Record<Limit, string>> = {
  none: '',
  moon: 'limited: the Moon needs short steps. Switch it off in the settings for up to 100 years a second',
  scheme: 'limited by the steps of the planets',
  encounter: 'slowed down: the probe passes a planet',
};

export const limitText = (limit: Limit): string => LIMITS[limit];

const UNITS = [
  [365.25 * 86400, 'year'],
  [86400, 'day'],
  [3600, 'hour'],
  [60, 'minute'],
  [1, 'second'],
] as const;

/** A rate of time, such as `5 days a second`. */
export function rateText(rate: number): string {
  if (rate === 0) return 'time stands still';
  const [length, unit] = UNITS.find(([seconds]) => rate >= 0.95 * seconds) ?? UNITS[4];
  const count = rate / length;
  const number = count < 10 ? Number(count.toPrecision(2)) : Math.round(count);
  return `${number} ${unit}${number === 1 ? '' : 's'} a second`;
}

/** A distance, such as `320 m`, `384 000 km` or `2.31 million km`. */
export function distanceText(km: number): string {
  if (!Number.isFinite(km)) return '–';
  if (km < 0.995) return `${Math.round(1000 * km)} m`;
  if (km < 10) return `${km.toFixed(1)} km`;
  if (km < 9.95e5) return `${Number(km.toPrecision(3)).toLocaleString('en').replaceAll(',', ' ')} km`;
  const millions = km / 1e6;
  return `${millions < 100 ? millions.toPrecision(3) : Math.round(millions)} million km`;
}

/** A part of a distance, such as `2·10⁻⁹`. */
export function shareText(share: number): string {
  if (!(share > 0)) return '0';
  const [digit, power10] = share.toExponential(0).split('e');
  const exponent = Number(power10);
  const digits = '⁰¹²³⁴⁵⁶⁷⁸⁹';
  const power = `${exponent < 0 ? '⁻' : ''}${[...String(Math.abs(exponent))].map((digit) => digits[Number(digit)]).join('')}`;
  return `${digit}·10${power}`;
}

export const speedText = (kmPerSecond: number): string => `${kmPerSecond.toFixed(2)} km/s`;

/** What the flight has come to, for the card at its end. */
export const OUTCOMES = {
  arrived: (mission: Mission) => `${LOOKS[mission.target].label} reached`,
  lost: (mission: Mission) => `${LOOKS[mission.target].label} missed`,
  crashed: (name: string) => `Crashed into ${name}`,
} as const;

export function flightLines(mission: Mission, deltaV: number, days: number, nearest: number): string[] {
  return [
    `Δv ${speedText(deltaV)} of ${mission.budget} km/s, ${Math.round(days)} days`,
    `Closest to ${label(mission.target)}: ${distanceText(nearest)}`,
  ];
}

export const shareLine = (mission: Mission, deltaV: number, days: number, points: number): string =>
  `Solar system, ${MISSION_WORDS[mission.id].title}: ${points} points with ${speedText(deltaV)} in ${Math.round(days)} days. Watch my flight:`;
