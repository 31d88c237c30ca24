/** The player's inputs other than dragging. They pass through a log, so that a seed and a log give the same run. */
import { keepState } from '@principia/physics';
import { type BouncingBalls, InputLog, type LoggedInput } from '@principia/scenes';
import { blast } from './blast.ts';
import type { Magnet } from './magnet.ts';
import type { Spout } from './spout.ts';
import type { Tilt } from './tilt.ts';

interface Point {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

export type BallInput =
  | { readonly kind: 'pour'; readonly isOpen: boolean }
  | ({ readonly kind: 'blast' } & Point)
  /** Puts the magnet at a point of the room, m, and switches it on. */
  | ({ readonly kind: 'magnet' } & Point)
  | { readonly kind: 'magnet off' }
  /** Direction of gravity; in 3D a unit vector, in 2D its part in the plane. */
  | ({ readonly kind: 'tilt' } & Point);

interface Parts {
  readonly spout: Spout;
  readonly magnet: Magnet;
  readonly tilt: Tilt;
}

/** Hands inputs to what they move at the beginning of the next step. @param script inputs of an earlier run to replay */
export function takeInputs(
  balls: BouncingBalls,
  { spout, magnet, tilt }: Parts,
  script?: readonly LoggedInput<BallInput>[],
): InputLog<BallInput> {
  const { world } = balls;
  const log = new InputLog<BallInput>(script);
  keepState(world, log.state);
  const use = (input: BallInput) => {
    if (input.kind === 'pour') spout.isOpen = input.isOpen;
    else if (input.kind === 'blast') blast(balls, input);
    else if (input.kind === 'magnet') magnet.attract(input);
    else if (input.kind === 'magnet off') magnet.release();
    else tilt.turn(input);
  };
  world.phases.input.unshift(() => log.take(world.tick, use));
  return log;
}
