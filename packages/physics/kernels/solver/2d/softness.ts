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
  // How much softer than rigid a joint between two bodies that move is, as a part of their own inverse effective mass.
  compliance: f64;
}

// What `soften` computed last.
export const softness = changetype<Softness>(memory.data(32, 8));

// A spring that a user sees swing, with no more damping than it has, as long as it is slow for the sub-steps: below hω = 1/2, a
// twelfth of their rate in Hz. With the part D of its speed that it keeps in one:
//
//   D = 1/(1 + 2a + 2a² + e)     a = ζhω     e = max(0, h²ω² - 1/4)          bias rate D hω²/(1 - D)     mass scale 1 - D
//
// Under a load it gives way by load/(m ω²) whatever D is. 1/(1 + 2a + 2a²) is exp(-2a) to second order; e > 0 keeps faster springs
// stable, since such a step is for h²ω² < 2 + 2/D. With D = 1 it is semi-implicit Euler, which loses nothing.
export function softenSpring(hertz: f64, dampingRatio: f64, h: f64): void {
  const omega = TWO_PI * hertz;
  const square = h * omega * (h * omega);
  const a = dampingRatio * h * omega;
  const keeps = min<f64>(1 / (1 + 2 * a * (1 + a) + max<f64>(0, square - 0.25)), MOST_KEPT);
  softness.biasRate = (keeps * square) / (h * (1 - keeps));
  softness.massScale = 1 - keeps;
  softness.impulseScale = keeps;
}

// What is left of the speed in a sub-step of a spring without damping: its rates must be finite.
const MOST_KEPT: f64 = 1 - 1e-9;

const TWO_PI: f64 = 6.283185307179586;

export function soften(hertz: f64, dampingRatio: f64, h: f64): void {
  const omega = TWO_PI * hertz;
  const a = 2 * dampingRatio + h * omega;
  const b = h * omega * a;
  softness.biasRate = omega / a;
  softness.massScale = b / (1 + b);
  softness.impulseScale = 1 / (1 + b);
}
