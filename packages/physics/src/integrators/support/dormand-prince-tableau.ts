// The coefficients of the Dormand-Prince pair: J. Comp. Appl. Math. 6, 19 (1980), RK5(4)7M; dense output: Hairer,
// Nørsett, Wanner: Solving Ordinary Differential Equations I (1993), II.6 and the code DOPRI5.
//
// Velocity is the derivative of position, so the position of a stage follows from accelerations alone: x_i = x + c_i
// h v + h² Σ (A A)_ij a_j. This halves the memory and changes results only by rounding.

/** Times of the stages, in steps. */
export const C = [0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1, 1];

/** Weights of the earlier stages, padded with zeros; the last row is the fifth-order solution. */
export const A = [
  [],
  [1 / 5],
  [3 / 40, 9 / 40],
  [44 / 45, -56 / 15, 32 / 9],
  [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
  [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656],
  [35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84],
].map((row) => C.map((_, j) => row[j] ?? 0));

/** Fifth-order minus fourth-order solution. */
export const E = [71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40];

/** Coefficients of the dense output beyond start, end and slopes. */
const D = [
  -12715105075 / 11282082432,
  0,
  87487479700 / 32700410799,
  -10690763975 / 1880347072,
  701980252875 / 199316789632,
  -1453857185 / 822651844,
  69997945 / 29380423,
];

/** Returns the weights of accelerations in positions, from weights of derivatives: w A. */
export function positionWeightsOf(weights: readonly number[]): number[] {
  return C.map((_, j) => weights.reduce((sum, w, i) => sum + w * A[i][j], 0));
}

/** A A, row by row. */
export const AA = A.map(positionWeightsOf);

/** E A. */
export const EA = positionWeightsOf(E);

/** Returns the weights of the derivatives at a fraction from 0 to 1 of the step: fourth order. */
export function denseWeights(fraction: number): number[] {
  const remaining = 1 - fraction;
  return C.map((_, i) => {
    const b = A[6][i];
    const start = (i === 0 ? 1 : 0) - b;
    const end = b - (i === 6 ? 1 : 0) - start;
    return fraction * (b + remaining * (start + fraction * (end + remaining * D[i])));
  });
}
