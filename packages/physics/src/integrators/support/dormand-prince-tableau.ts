// The coefficients of Dormand and Prince's pair: J. Comp. Appl. Math. 6, 19 (1980), RK5(4)7M; dense output: Hairer,
// Nørsett, Wanner: Solving Ordinary Differential Equations I (1993), II.6 and the code DOPRI5.
//
// Positions change at the rate of velocities, so the position of a stage follows from accelerations alone:
// x_i = x + c_i h v + h² Σ (A A)_ij a_j. That halves what is stored, and changes nothing but rounding.

/** When the stages are, in steps. */
export const C = [0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1, 1];

/** Weights of the stages before, filled up with zeros; the last row is the fifth-order solution. */
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

/** The part of the dense output that is neither start, end nor slope there. */
const D = [
  -12715105075 / 11282082432,
  0,
  87487479700 / 32700410799,
  -10690763975 / 1880347072,
  701980252875 / 199316789632,
  -1453857185 / 822651844,
  69997945 / 29380423,
];

/** Weights of accelerations in positions, from weights of derivatives: w A. */
export function twice(weights: readonly number[]): number[] {
  return C.map((_, j) => weights.reduce((sum, w, i) => sum + w * A[i][j], 0));
}

/** A A, row by row. */
export const AA = A.map(twice);

/** E A. */
export const EA = twice(E);

/** Weights of the derivatives at a moment between start (0) and end (1) of the step: fourth order. */
export function denseWeights(moment: number): number[] {
  const back = 1 - moment;
  return C.map((_, i) => {
    const b = A[6][i];
    const start = (i === 0 ? 1 : 0) - b;
    const end = b - (i === 6 ? 1 : 0) - start;
    return moment * (b + back * (start + moment * (end + back * D[i])));
  });
}
