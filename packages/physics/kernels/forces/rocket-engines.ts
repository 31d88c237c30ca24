// External forces: engines.
import { columns, get, put } from '../memory/columns';
import { logarithm } from '../math/elementary';

// Addresses of the columns of the component Engine; src/forces/rocket-engines.ts writes them.
@unmanaged
export class EngineColumns {
  fuel: usize;
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
// force that gives the remaining mass exactly the velocity v_e ln(m / (m - b)) in the step (Tsiolkovsky).
export function burnFuel(engines: usize, dt: f64, first: i32, last: i32): void {
  const e = changetype<EngineColumns>(engines);
  const fuel = e.fuel;
  const rate = e.burnRate;
  const tx = e.thrustX;
  const ty = e.thrustY;
  const tz = e.thrustZ;
  const c = columns();
  for (let row = first; row < last; row++) {
    if (get(rate, row) == 0 && get(tx, row) == 0 && get(ty, row) == 0 && get(tz, row) == 0) continue;
    const mass = get(c.mass, row);
    const available = get(fuel, row);
    const requested = <real>(<f64>get(rate, row) * <f64>get(e.throttle, row) * dt);
    // A rocket made of fuel only would reach infinite speed, so a millionth of its mass remains and the engine stops.
    const maxBurnt = mass * <real>0.999999;
    const limited = max<real>(0, min<real>(requested, available));
    const burnt = min<real>(limited, maxBurnt);
    const remaining = mass - burnt;
    const gain = remaining > 0 ? <f64>get(e.exhaustSpeed, row) * logarithm(<f64>mass / <f64>remaining) : 0;
    const magnitude = (<f64>remaining * gain) / dt;
    put(fuel, row, limited > maxBurnt ? 0 : available - burnt);
    if (mass > 0) put(c.mass, row, remaining);
    put(tx, row, <real>(magnitude * <f64>get(e.x, row)));
    put(ty, row, <real>(magnitude * <f64>get(e.y, row)));
    put(tz, row, <real>(magnitude * <f64>get(e.z, row)));
  }
}
