/** The instruments: throttle, airspeed, artificial horizon with heading, altitude and vertical speed, on one canvas. */
import { decimal } from '@principia/shell';
import { stallSpeed } from './aircraft.ts';
import type { Flight } from './sim.ts';
import { WORDS } from './words.ts';

/** Size, CSS pixels. */
const WIDTH = 340;
const HEIGHT = 168;
const KMH = 3.6;
const DEGREES = 180 / Math.PI;

const INK = '#f2f6ff';
const WARNING = '#ff6b5e';
const GOOD = '#6fe08f';
const ACCENT = '#ffb454';

export interface Instruments {
  readonly element: HTMLCanvasElement;
  draw(flight: Flight): void;
}

export function createInstruments(): Instruments {
  const element = document.createElement('canvas');
  const ratio = Math.min(2, globalThis.devicePixelRatio || 1);
  element.className = 'fs-instruments';
  element.setAttribute('role', 'img');
  element.setAttribute('aria-label', WORDS.instruments);
  [element.width, element.height] = [WIDTH * ratio, HEIGHT * ratio];
  const context = element.getContext('2d');
  if (context === null) throw new Error('This browser offers no 2D canvas.');
  context.scale(ratio, ratio);
  context.textBaseline = 'middle';
  return {
    element,
    draw(flight) {
      context.clearRect(0, 0, WIDTH, HEIGHT);
      drawThrottle(context, flight);
      drawTape(context, 34, 'km/h', KMH * flight.attitude.airspeed, 10, 40, KMH * stallSpeed());
      drawHorizon(context, flight);
      drawTape(context, 244, 'm', Math.max(0, flight.altitude), 10, 40, 0);
      drawClimb(context, flight.climb);
      drawHeading(context, flight.attitude.heading);
    },
  };
}

type Context = CanvasRenderingContext2D;
const TOP = 16;
const BODY = 118;
const MIDDLE = TOP + BODY / 2;

function drawThrottle(context: Context, { pilot }: Flight): void {
  panel(context, 4, TOP, 22, BODY);
  context.fillStyle = ACCENT;
  const length = (BODY - 8) * pilot.throttle;
  context.fillRect(8, TOP + BODY - 4 - length, 14, length);
  label(context, WORDS.throttle, 17, TOP - 8);
  if (pilot.brake > 0.1) label(context, WORDS.brake, 30, TOP + BODY + 14, WARNING);
}

/** A scale that moves behind its present value. */
function drawTape(
  context: Context,
  x: number,
  unit: string,
  value: number,
  step: number,
  range: number,
  warn: number,
): void {
  const width = 58;
  panel(context, x, TOP, width, BODY);
  context.save();
  context.beginPath();
  context.rect(x, TOP, width, BODY);
  context.clip();
  const scale = BODY / (2 * range);
  context.strokeStyle = '#ffffff70';
  context.lineWidth = 1;
  context.beginPath();
  for (let mark = step * Math.ceil((value - range) / step); mark <= value + range; mark += step) {
    if (mark < 0) continue;
    const y = MIDDLE + (value - mark) * scale;
    context.moveTo(x + width - 8, y);
    context.lineTo(x + width, y);
    if (mark % (2 * step) === 0) label(context, String(mark), x + 24, y);
  }
  context.stroke();
  if (warn > 0) {
    context.fillStyle = WARNING;
    const from = MIDDLE + (value - warn) * scale;
    context.fillRect(x + width - 3, Math.max(TOP, from), 3, Math.max(0, TOP + BODY - from));
  }
  context.restore();
  context.fillStyle = '#0b1226';
  context.fillRect(x + 1, MIDDLE - 13, width - 2, 26);
  context.strokeStyle = warn > 0 && value < warn ? WARNING : '#ffffffa0';
  context.strokeRect(x + 1, MIDDLE - 13, width - 2, 26);
  label(context, String(Math.round(value)), x + width / 2, MIDDLE, INK, '700 18px');
  label(context, unit, x + width / 2, TOP - 8);
}

function drawHorizon(context: Context, { attitude }: Flight): void {
  const [x, width] = [100, 136];
  const centre = x + width / 2;
  context.save();
  context.beginPath();
  context.roundRect(x, TOP, width, BODY, 10);
  context.clip();
  context.translate(centre, MIDDLE);
  context.rotate(-attitude.bank);
  const scale = BODY / 50;
  context.translate(0, Math.max(-90, Math.min(90, attitude.pitch * DEGREES)) * scale);
  context.fillStyle = '#3f8fe0';
  context.fillRect(-400, -500, 800, 500);
  context.fillStyle = '#8a5a32';
  context.fillRect(-400, 0, 800, 500);
  context.fillStyle = INK;
  context.fillRect(-400, -1, 800, 2);
  for (let pitch = -60; pitch <= 60; pitch += 10) {
    if (pitch === 0) continue;
    context.fillRect(-22, -pitch * scale, 44, 1);
    label(context, String(Math.abs(pitch)), 34, -pitch * scale, INK, '600 11px');
    context.fillRect(-10, (5 - pitch) * scale, 20, 1);
  }
  context.restore();
  context.strokeStyle = ACCENT;
  context.lineWidth = 3;
  context.beginPath();
  for (const side of [-1, 1]) {
    context.moveTo(centre + side * 46, MIDDLE);
    context.lineTo(centre + side * 18, MIDDLE);
    context.lineTo(centre + side * 10, MIDDLE + 8);
  }
  context.stroke();
  context.fillStyle = ACCENT;
  context.fillRect(centre - 2, MIDDLE - 2, 4, 4);
}

function drawClimb(context: Context, climb: number): void {
  const x = 310;
  panel(context, x, TOP, 24, BODY);
  const length = (Math.max(-6, Math.min(6, climb)) / 6) * (BODY / 2 - 4);
  context.fillStyle = climb < -4.5 ? WARNING : GOOD;
  context.fillRect(x + 6, MIDDLE - Math.max(0, length), 12, Math.abs(length));
  context.fillStyle = '#ffffff90';
  context.fillRect(x + 2, MIDDLE - 0.5, 20, 1);
  label(context, 'm/s', x + 12, TOP - 8);
  label(context, decimal(climb, 1), x + 10, TOP + BODY + 14);
}

function drawHeading(context: Context, heading: number): void {
  const [x, width, y] = [100, 136, TOP + BODY + 4];
  panel(context, x, y, width, 24);
  context.save();
  context.beginPath();
  context.rect(x, y, width, 24);
  context.clip();
  const degrees = heading * DEGREES;
  for (let mark = 15 * Math.ceil((degrees - 45) / 15); mark <= degrees + 45; mark += 15) {
    const at = x + width / 2 + (mark - degrees) * 1.6;
    const around = (mark + 360) % 360;
    // A letter fades before the edge would cut it.
    context.globalAlpha = Math.max(0, Math.min(1, (37 - Math.abs(mark - degrees)) / 7));
    label(context, around % 45 === 0 ? WORDS.compass[around / 45] : '·', at, y + 13);
  }
  context.restore();
  context.fillStyle = ACCENT;
  context.fillRect(x + width / 2 - 1, y, 2, 5);
  label(context, `${String(Math.round(degrees) % 360).padStart(3, '0')}°`, x + width + 30, y + 12, INK, '600 13.5px');
}

function panel(context: Context, x: number, y: number, width: number, height: number): void {
  context.fillStyle = '#101a33d8';
  context.beginPath();
  context.roundRect(x, y, width, height, 6);
  context.fill();
}

function label(context: Context, text: string, x: number, y: number, color = INK, font = '600 12.5px'): void {
  context.font = `${font} system-ui, sans-serif`;
  context.textAlign = 'center';
  context.fillStyle = color;
  context.fillText(text, x, y);
}
