// A constraint as a damped spring of frequency f and damping ratio ζ, solved implicitly in sub-steps of h seconds. With
// ω = 2π f and a = 2ζ + hω:
//
//   bias rate ω/a        mass scale hωa/(1 + hωa)        impulse scale 1/(1 + hωa)
//
// Source: Catto, Soft Contact / Solver2D (2024), box2d.org/posts/2024/02/solver2d.
@unmanaged
class Softness {
  biasRate: f64;
  massScale: f64;
  impulseScale: f64;
}

// What `soften` computed last.
export const softness = changetype<Softness>(memory.data(24, 8));

const TWO_PI: f64 = 6.283185307179586;

export function soften(hertz: f64, dampingRatio: f64, h: f64): void {
  const omega = TWO_PI * hertz;
  const a = 2 * dampingRatio + h * omega;
  const b = h * omega * a;
  softness.biasRate = omega / a;
  softness.massScale = b / (1 + b);
  softness.impulseScale = 1 / (1 + b);
}
