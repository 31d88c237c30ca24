import type { GameDefinition, Simulation } from './game.ts';
import type { Settings } from './settings.ts';

/** The lines of the help sheet: what every game has, and what this one adds. */
export function helpLines<S extends Settings, Sim extends Simulation>(
  game: GameDefinition<S, Sim>,
): (readonly [string, string])[] {
  const renderers = Object.values(game.renderers);
  const switches = Object.values(game.settings).flatMap((setting) =>
    setting.kind === 'switch' && setting.key !== undefined
      ? [[setting.key.toUpperCase(), `${setting.label} on or off`] as const]
      : [],
  );
  const isArrowTaken = Object.values(game.controls?.buttons ?? {}).some(({ keys }) => keys.includes('arrowright'));
  return [
    ...(game.help ?? []),
    ['Space', 'pause and go on'],
    [isArrowTaken ? '.' : '. or →', 'one step'],
    ['R', 'start again'],
    ['S', 'slow motion'],
    ...(renderers.length > 1
      ? [
          [
            renderers.map(({ dimensions }) => dimensions).join(' '),
            `draw in ${renderers.map((r) => r.label).join(' or ')}`,
          ] as const,
        ]
      : []),
    ...switches,
    ['F, + −', 'see everything, closer, farther'],
    ['E', 'energy plot'],
    ['P', 'panel'],
    ['H', 'this help'],
  ];
}
