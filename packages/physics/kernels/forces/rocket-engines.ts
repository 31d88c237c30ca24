// External forces: engines.
import { columns, get, put } from '../memory/columns';
import { logarithm } from '../math/elementary';

// Addresses of the columns of the component Engine; src/forces/rocket-engines.ts writes them.
@unmanaged
export class EngineColumns {
  fuel: usize;
  fuelRemainder: usize;
  massRemainder: usize;
  burnRate: usize;
  throttle: usize;
  exhaustSpeed: usize;
  x: usize;
  y: usize;
  z: usize;
  thrustX: usize;
  thrustY: usize;
  thrustZ: usize;
}

// Burns the fuel of a step: fuel and mass decrease by the same amount b, and the engine's thrust becomes the constant
// force that gives the remaining mass exactly the velocity v_e ln(m / (m - b)) in the step (Tsiolkovsky). What a step burns
// may be less than the last digit of a mass in single precision: what both are rounded by is kept for the next step.
export function burnFuel(engines: usize, dt: f64, first: i32, last: i32): void {
  const e = changetype<EngineColumns>(engines);
  const fuel = e.fuel;
  const rate = e.burnRate;
  const tx = e.thrustX;
  const ty = e.thrustY;
  const tz = e.thrustZ;
  const masses = columns().mass;
  for (let row = first; row < last; row++) {
    if (get(rate, row) == 0 && get(tx, row) == 0 && get(ty, row) == 0 && get(tz, row) == 0) continue;
    const mass = exact(masses, e.massRemainder, row);
    const available = get(fuel, row) > 0 ? exact(fuel, e.fuelRemainder, row) : 0;
    const requested = <f64>get(rate, row) * <f64>get(e.throttle, row) * dt;
    // A rocket made of fuel only would reach infinite speed, so a millionth of its mass remains and the engine stops.
    const maxBurnt = mass * 0.999999;
    const limited = max<f64>(0, min<f64>(requested, available));
    const burnt = min<f64>(limited, maxBurnt);
    const remaining = mass - burnt;
    const gain = remaining > 0 ? <f64>get(e.exhaustSpeed, row) * logarithm(mass / remaining) : 0;
    const magnitude = (remaining * gain) / dt;
    keep(fuel, e.fuelRemainder, row, limited > maxBurnt ? 0 : available - burnt);
    if (mass > 0) keep(masses, e.massRemainder, row, remaining);
    put(tx, row, <real>(magnitude * <f64>get(e.x, row)));
    put(ty, row, <real>(magnitude * <f64>get(e.y, row)));
    put(tz, row, <real>(magnitude * <f64>get(e.z, row)));
  }
}

// A number with what it was rounded by; without, if it was written since.
// @ts-ignore: decorator
@inline function exact(column: usize, remainders: usize, row: i32): f64 {
  const value = get(column, row);
  const sum = <f64>value + <f64>get(remainders, row);
  return <real>sum == value ? sum : <f64>value;
}

// @ts-ignore: decorator
@inline function keep(column: usize, remainders: usize, row: i32, value: f64): void {
  const rounded = <real>value;
  put(column, row, rounded);
  put(remainders, row, <real>(value - <f64>rounded));
}
