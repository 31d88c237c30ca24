/** The text of the game. */
import type { Ending } from './sim.ts';

export const WORDS = {
  title: 'Submarine',
  start: 'Hold ▼ to flood the tank, ▲ to blow it out; ◀ ▶ drive; X or ● pings',
  goal: (taken: number, count: number) =>
    taken < count ? `${taken} of ${count} crates aboard` : 'All aboard – come up beside the ship',
  tooDeep: 'Too deep – the hull gives way!',
  lowAir: 'Little compressed air is left: come up for more',
  lowBreath: 'The air to breathe runs out',
  depth: (depth: number, pressure: number) => `${Math.max(0, depth).toFixed(0)} m, ${pressure.toFixed(1)} atm`,
  density: (ratio: number) => `density ${ratio.toFixed(3)}`,
  speed: (speed: number) => `${speed.toFixed(1)} m/s`,
  gauges: { tank: 'tank', hull: 'hull', air: 'compressed air', breath: 'breath' },
} as const;

export const ENDINGS: Readonly<Record<Exclude<Ending, 'none'>, string>> = {
  won: 'All brought up',
  crushed: 'Crushed by the depth',
  wrecked: 'Wrecked on the rocks',
  suffocated: 'Out of breath',
};
