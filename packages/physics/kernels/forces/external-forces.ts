// Forces that come from outside: engines and blasts.
import { columns, get, put } from '../memory/columns';
import { logarithm } from '../math/elementary';

// Where the columns of the component Engine are; src/forces/rocket-engines.ts fills it.
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

// Burns the fuel of one step: fuel and mass fall by the same amount b, and the engine's thrust becomes the constant
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
    const left = get(fuel, row);
    const wanted = <real>(<f64>get(rate, row) * <f64>get(e.throttle, row) * dt);
    // A rocket of nothing but fuel would end with infinite speed: a millionth of its mass stays, and the fire dies.
    const most = mass * <real>0.999999;
    const asked = max<real>(0, min<real>(wanted, left));
    const burnt = min<real>(asked, most);
    const rest = mass - burnt;
    const gain = rest > 0 ? <f64>get(e.exhaustSpeed, row) * logarithm(<f64>mass / <f64>rest) : 0;
    const size = (<f64>rest * gain) / dt;
    put(fuel, row, asked > most ? 0 : left - burnt);
    if (mass > 0) put(c.mass, row, rest);
    put(tx, row, <real>(size * <f64>get(e.x, row)));
    put(ty, row, <real>(size * <f64>get(e.y, row)));
    put(tz, row, <real>(size * <f64>get(e.z, row)));
  }
}

// Velocity change of a blast: along r, impulse J (1 - r/R)^fall within R. At the very centre there is no direction.
export function blast(cx: f64, cy: f64, cz: f64, impulse: f64, radius: f64, fall: i32, first: i32, last: i32): void {
  const c = columns();
  for (let row = first; row < last; row++) {
    const mass = <f64>get(c.mass, row);
    if (!(mass > 0)) continue;
    const x = <f64>get(c.positionX, row) - cx;
    const y = <f64>get(c.positionY, row) - cy;
    const z = <f64>get(c.positionZ, row) - cz;
    const r = sqrt<f64>(x * x + y * y + z * z);
    if (!(r > 0) || r >= radius) continue;
    let size = impulse / (mass * r);
    for (let i = 0; i < fall; i++) size *= 1 - r / radius;
    put(c.velocityX, row, get(c.velocityX, row) + <real>(size * x));
    put(c.velocityY, row, get(c.velocityY, row) + <real>(size * y));
    put(c.velocityZ, row, get(c.velocityZ, row) + <real>(size * z));
  }
}
