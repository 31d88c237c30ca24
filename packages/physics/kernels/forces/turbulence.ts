// Drag in a turbulent wind: a sum of plane waves, each across its own direction and therefore without divergence.
//
//   u(x, t) = mean + sum_j a_j cos(k_j x + phase_j(t)),   a_j perpendicular to k_j
//
// The phases come in with the call, so that the field is a function of time and not of the step.
import { columns } from '../columns';
import { LANES, add, at, mul, splat, sub } from '../lanes';

// A mode: wave vector over 2 pi (turns per metre), amplitude, and the phase now (turns). Seven f64.
const MODE_BYTES: usize = 56;

// cos(2 pi t) for t in turns: reduced to half a turn either way, then its Taylor series to the 16th power, whose last
// coefficient takes up most of the next term. Error below 5e-9 in f64, an ulp or two in f32.
// @ts-ignore: decorator
@inline function cosineOfTurns(turns: v128): v128 {
  const t = sub(turns, v128.nearest<real>(turns));
  const z = mul(t, t);
  let c = splat(<real>0.2734560008);
  c = add(mul(c, z), splat(<real>-1.71439071109));
  c = add(mul(c, z), splat(<real>7.90353637132));
  c = add(mul(c, z), splat(<real>-26.4262567834));
  c = add(mul(c, z), splat(<real>60.2446413719));
  c = add(mul(c, z), splat(<real>-85.4568172067));
  c = add(mul(c, z), splat(<real>64.9393940227));
  c = add(mul(c, z), splat(<real>-19.7392088022));
  return add(mul(c, z), splat(1));
}

// F -= (c + k |w|) w with w = v - u, for the columns of linear (c) and quadratic (k) drag.
export function turbulentDrag(
  fx: usize,
  fy: usize,
  fz: usize,
  linear: usize,
  quadratic: usize,
  modes: usize,
  count: i32,
  meanX: real,
  meanY: real,
  meanZ: real,
  first: i32,
  last: i32,
): void {
  const c = columns();
  const end = modes + <usize>count * MODE_BYTES;
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const cl = v128.load(linear + o);
    const kq = v128.load(quadratic + o);
    if (!v128.any_true(v128.or(cl, kq))) continue;
    const x = v128.load(c.positionX + o);
    const y = v128.load(c.positionY + o);
    const z = v128.load(c.positionZ + o);
    let ux = splat(meanX);
    let uy = splat(meanY);
    let uz = splat(meanZ);
    for (let mode = modes; mode < end; mode += MODE_BYTES) {
      const turns = add(
        add(mul(x, splat(<real>load<f64>(mode))), mul(y, splat(<real>load<f64>(mode, 8)))),
        add(mul(z, splat(<real>load<f64>(mode, 16))), splat(<real>load<f64>(mode, 48))),
      );
      const wave = cosineOfTurns(turns);
      ux = add(ux, mul(wave, splat(<real>load<f64>(mode, 24))));
      uy = add(uy, mul(wave, splat(<real>load<f64>(mode, 32))));
      uz = add(uz, mul(wave, splat(<real>load<f64>(mode, 40))));
    }
    const wx = sub(v128.load(c.velocityX + o), ux);
    const wy = sub(v128.load(c.velocityY + o), uy);
    const wz = sub(v128.load(c.velocityZ + o), uz);
    const speed = v128.sqrt<real>(add(add(mul(wx, wx), mul(wy, wy)), mul(wz, wz)));
    const size = add(cl, mul(kq, speed));
    v128.store(fx + o, sub(v128.load(fx + o), mul(size, wx)));
    v128.store(fy + o, sub(v128.load(fy + o), mul(size, wy)));
    v128.store(fz + o, sub(v128.load(fz + o), mul(size, wz)));
  }
}
