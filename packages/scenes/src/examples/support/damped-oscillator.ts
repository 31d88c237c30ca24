/** The exact motion of a damped oscillator. */
import { cos, exp, sin } from '@principia/physics';

/** What drives it back and brakes it, for a mass of 1 kg: N/m and kg/s. */
export interface Oscillator {
  readonly stiffness: number;
  readonly damping: number;
}

/** Displacement after a time t from a start at `x` with the velocity `v`: damped weakly, critically or strongly. */
export function displacement({ stiffness, damping }: Oscillator, x: number, v: number, t: number): number {
  const gamma = damping / 2;
  const square = stiffness - gamma * gamma;
  const push = v + gamma * x;
  if (Math.abs(square) < 1e-9 * stiffness) return exp(-gamma * t) * (x + push * t);
  const omega = Math.sqrt(Math.abs(square));
  if (square > 0) return exp(-gamma * t) * (x * cos(omega * t) + (push / omega) * sin(omega * t));
  const [slow, fast] = [exp((omega - gamma) * t), exp((-omega - gamma) * t)];
  return (x * (slow + fast) + (push / omega) * (slow - fast)) / 2;
}
