/** The direction of gravity on the screen of a phone or tablet, and a button that switches it on. */
import { cos, sin } from '@principia/physics';
import { element, hasCoarsePointer } from '@principia/shell';
import { WORDS } from './words.ts';

export interface Direction {
  x: number;
  y: number;
  z: number;
}

export const DOWNWARDS: Readonly<Direction> = { x: 0, y: -1, z: 0 };

const RADIANS = Math.PI / 180;
/** Steps in which a direction is passed on, so that a hand at rest sends nothing new. */
const STEPS = 64;

/**
 * Direction of gravity in the frame of the screen: x to the right, y upwards, z towards the player. A device flat on a
 * table gives (0, 0, −1), one held upright (0, −1, 0). From the angles of W3C, Device Orientation and Motion, section 3:
 * the frame of the device is that of the Earth turned by α about z, β about x and γ about y.
 * @param beta β, degrees @param gamma γ, degrees @param angle by which the screen is turned, `screen.orientation.angle`
 */
export function gravityOnScreen(beta: number, gamma: number, angle: number): Direction {
  const x = cos(RADIANS * beta) * sin(RADIANS * gamma);
  const y = -sin(RADIANS * beta);
  const z = -cos(RADIANS * beta) * cos(RADIANS * gamma);
  const [turnCos, turnSin] = [cos(RADIANS * angle), sin(RADIANS * angle)];
  const round = (value: number) => Math.round(STEPS * value) / STEPS + 0;
  return { x: round(turnCos * x - turnSin * y), y: round(turnSin * x + turnCos * y), z: round(z) };
}

export interface DeviceTilt {
  /** Passes the present direction on again: call it when the world was replaced. */
  refresh(): void;
  destroy(): void;
}

/** iOS asks the player, and only after a tap. */
type Permission = { requestPermission?: () => Promise<'granted' | 'denied'> };

/**
 * Adds a button where there is a sensor: at once on touch screens where permission may have to be asked for, else with its
 * first measurement.
 * @param turn receives every new direction, and downwards when the player switches it off
 */
export function offerTilt(
  parent: HTMLElement,
  turn: (direction: Readonly<Direction>) => void,
  showMessage: (sentence: string) => void,
): DeviceTilt {
  const { requestPermission } = (globalThis.DeviceOrientationEvent ?? {}) as Permission;
  const button = element('button', 'tilt-button', { type: 'button', 'aria-pressed': 'false' }, WORDS.tilt);
  button.title = WORDS.tiltHint;
  button.hidden = requestPermission === undefined || !hasCoarsePointer();
  parent.append(element('style', '', {}, STYLE), button);
  const stop = new AbortController();
  let isOn = false;
  let hasMeasured = false;
  let sent = DOWNWARDS;
  const send = (direction: Readonly<Direction>) => {
    if (direction.x === sent.x && direction.y === sent.y && direction.z === sent.z) return;
    sent = direction;
    turn(direction);
  };
  const measure = ({ beta, gamma }: DeviceOrientationEvent) => {
    // Where there is no sensor, browsers send one event without angles.
    hasMeasured ||= beta !== null && gamma !== null;
    button.hidden = !hasMeasured;
    if (beta === null || gamma === null) return;
    if (isOn) send(gravityOnScreen(beta, gamma, globalThis.screen?.orientation?.angle ?? 0));
  };
  const set = (on: boolean) => {
    isOn = on;
    button.setAttribute('aria-pressed', String(on));
    if (!on) send(DOWNWARDS);
  };
  button.addEventListener('click', async () => {
    if (isOn || (await isAllowed(requestPermission))) set(!isOn);
    else showMessage(WORDS.noTilt);
  });
  globalThis.addEventListener('deviceorientation', measure, { signal: stop.signal });
  return {
    refresh() {
      if (sent !== DOWNWARDS) turn(sent);
    },
    destroy: () => stop.abort(),
  };
}

async function isAllowed(request: Permission['requestPermission']): Promise<boolean> {
  if (request === undefined) return true;
  try {
    return (await request.call(globalThis.DeviceOrientationEvent)) === 'granted';
  } catch {
    return false;
  }
}

const STYLE = `
.tilt-button { position: absolute; left: calc(max(20px, env(safe-area-inset-left)) + 164px);
  bottom: max(24px, env(safe-area-inset-bottom)); min-width: 64px; height: 64px;
  border: 1px solid var(--line); border-radius: 20px; background: #ffffff1c; color: var(--ink); font: 600 14px/1 inherit;
  font-family: inherit; touch-action: manipulation }
.tilt-button[aria-pressed=true] { background: var(--accent); border-color: transparent; color: #1c1503 }
.tilt-button:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px }
`;
