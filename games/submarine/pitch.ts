/**
 * The pitch of the boat: torques about its centre of mass, which lies below that of the hull.
 *
 *   I dω/dt = Σ B_i x_i + ½ ρ A C_L δ l u |u| − ½ ρ A a l² |u| ω − ½ ρ C_d D (L⁴/32) ω |ω|
 *   x_i = s_i cos θ − h sin θ,  B_i = ρ g V f_i/n
 *
 *   θ  pitch, nose up, rad    ω  its rate    s_i  place along the hull of one of n strips, m    f_i  its immersed part
 *   h  height of the hull's centre above that of the mass, m    u  speed along the hull through the water, m/s
 *   A, l, δ  area, arm and position of the planes at bow and stern, which are turned against each other: they turn the boat and
 *   do not lift it    a  slope of their lift, 1/rad    L, D  length and height of the hull, m
 *
 * Deep down the buoyancy's torque is −B h sin θ; at the surface the waterline adds that of a ship. Inertia is that of a rod and
 * as much again for the water that moves with it (Lamb, Hydrodynamics, section 92). The last term is the drag across a hull that
 * turns. Fixed fins are taken to balance the moment of a hull that moves askew. Fossen, Guidance and Control of Ocean Vehicles,
 * sections 2.4 and 4.2.
 */
import { cos, sin } from '@principia/physics';
import { DENSITY, GRAVITY, HULL } from './hull.ts';

/** Planes: sum of their areas, m², lift when fully turned, slope of the lift, 1/rad, arm, m, and the time they take, s. */
export const PLANES = { area: 4, lift: 0.6, slope: 3, arm: 6, time: 0.6 } as const;
/** h, m. */
export const STABILITY = 0.6;
export const STRIPS = 16;
export const INERTIA = (2 * DENSITY * HULL.volume * HULL.length * HULL.length) / 12;
const CROSS_DRAG = (0.5 * DENSITY * 2 * HULL.halfHeight * HULL.length ** 4) / 32;

/** What is saved of the pitch. */
export interface Pitch {
  pitch: number;
  rate: number;
  /** Planes, −1 nose down to 1 nose up. */
  planes: number;
  /** 1 heads to the right, −1 to the left. */
  facing: number;
}

/** Torque of the buoyancy about the centre of mass, nose up, N m. @param depth of the hull's centre, m */
export function buoyancyTorque(depth: number, pitch: number, volume: number): number {
  const [c, s] = [cos(pitch), sin(pitch)];
  let sum = 0;
  for (let i = 0; i < STRIPS; i++) {
    const along = ((i + 0.5) / STRIPS - 0.5) * HULL.length;
    const fraction = 0.5 + (0.5 * (depth - along * s)) / HULL.halfHeight;
    sum += Math.min(1, Math.max(0, fraction)) * (along * c - STABILITY * s);
  }
  return (DENSITY * GRAVITY * volume * sum) / STRIPS;
}

/** Torque of the planes and of the water that resists turning, N m. @param speed u, m/s */
export function waterTorque({ planes, rate }: Readonly<Pitch>, speed: number): number {
  const { area, lift, slope, arm } = PLANES;
  const size = Math.abs(speed);
  const pressure = 0.5 * DENSITY * area * arm;
  return pressure * (lift * planes * speed * size - slope * arm * size * rate) - CROSS_DRAG * rate * Math.abs(rate);
}

/** Moves planes and pitch by one step. @param wanted position of the planes */
export function stepPitch(
  state: Pitch,
  wanted: number,
  at: { readonly depth: number; readonly volume: number; readonly speed: number },
  dt: number,
): void {
  const most = dt / PLANES.time;
  state.planes += Math.min(most, Math.max(-most, wanted - state.planes));
  const torque = buoyancyTorque(at.depth, state.pitch, at.volume) + waterTorque(state, at.speed);
  state.rate += (dt * torque) / INERTIA;
  state.pitch += dt * state.rate;
}
