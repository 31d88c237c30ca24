/** Hands that play the game of black holes through its page, and a plan of what they have to do to win. */
import { step } from '@principia/physics';
import type { Page } from 'playwright-core';
import { Autopilot } from '../../games/black-hole/autopilot.ts';
import type { Heading } from '../../games/black-hole/heading.ts';
import { createGame } from '../../games/black-hole/sim.ts';
import { body, frames, steps } from './game-page.ts';
import {
  fingerOf,
  mouseOf,
  type Pointer,
  type Spot,
  type Steer,
  steerByKeys,
  steerByPointer,
  steerByStick,
} from './hands.ts';

export const VALUES = { fuel: true, moving: true, steep: false, autopilot: false };

/** A heading, or nothing, and for how many steps. */
export interface Move {
  readonly heading: Heading | undefined;
  readonly steps: number;
}

/** What wins the first level of a seed, found without a page. @throws Error where the autopilot does not win it */
export function winningMoves(seed: number): Move[] {
  const game = createGame({ values: VALUES, seed });
  const pilot = new Autopilot(game.scene, 99);
  const moves: { heading: Heading | undefined; steps: number }[] = [];
  for (let tick = 0; game.rules.dodged === 0; tick++) {
    if (tick > 6000 || game.rules.phase === 'breath')
      throw new Error(`The autopilot does not win the first level of ${seed}.`);
    const last = moves[moves.length - 1];
    // A hand is no faster than a quarter of a second.
    const heading = tick === 0 ? 'up' : tick % 30 === 0 ? pilot.steer(game.dt * 30) : last.heading;
    if (heading === last?.heading) last.steps++;
    else {
      game.press(heading ?? 'release');
      moves.push({ heading, steps: 1 });
    }
    step(game.world, game.dt);
  }
  return moves;
}

/** One way to steer. */
export interface Hand {
  /** Pushes one way, or lets go. */
  push(heading: Heading | undefined): Promise<unknown>;
}

const WAYS: Record<Heading, readonly [number, number]> = { up: [0, 1], left: [-1, 0], down: [0, -1], right: [1, 0] };
/** From the ship to the pointer, CSS pixels: enough for full thrust. */
const REACH = 70;

const handOf = (steer: Steer): Hand => ({ push: (heading) => steer(...(heading ? WAYS[heading] : ([0, 0] as const))) });

/** The ship is where the pointer steers from, as it is drawn. */
function aboutShip(page: Page, pointer: Pointer): Hand {
  const place = async () => {
    await frames(page);
    return (await body(page, 0)).screen as Spot;
  };
  return handOf(steerByPointer(pointer, place, REACH));
}

const keys = async (page: Page): Promise<Hand> => handOf(await steerByKeys(page));
const mouse = (page: Page): Hand => aboutShip(page, mouseOf(page));
const finger = async (page: Page): Promise<Hand> => aboutShip(page, await fingerOf(page));

async function touchStick(page: Page): Promise<Hand> {
  await page.addStyleTag({ content: '.game-pad { display: grid !important }' });
  return handOf(steerByStick(page, await fingerOf(page)));
}

/** The left stick of a gamepad. Browsers have no way to plug one in for a test, so the page is told of one. */
async function gamepad(page: Page): Promise<Hand> {
  await page.evaluate(() => {
    const buttons = Array.from({ length: 17 }, () => ({ pressed: false, touched: false, value: 0 }));
    Object.assign(globalThis, { stick: [0, 0, 0, 0] });
    const { stick } = globalThis as unknown as { stick: number[] };
    navigator.getGamepads = () => [{ connected: true, index: 0, axes: stick, buttons } as unknown as Gamepad];
    globalThis.dispatchEvent(new Event('gamepadconnected'));
  });
  return {
    async push(heading) {
      const way = heading === undefined ? ([0, 0] as const) : WAYS[heading];
      await page.evaluate(([x, y]) => {
        const { stick } = globalThis as unknown as { stick: number[] };
        stick[0] = x;
        stick[1] = -y;
      }, way);
      await frames(page);
    },
  };
}

export const HANDS = { keys, mouse, finger, touchStick, gamepad };

/** Does what a plan says, and lets go. */
export async function perform(page: Page, hand: Hand, moves: readonly Move[]): Promise<void> {
  for (const move of moves) {
    await hand.push(move.heading);
    await steps(page, move.steps);
  }
  await hand.push(undefined);
  await steps(page, 1);
}
