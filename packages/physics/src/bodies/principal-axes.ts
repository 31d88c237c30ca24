// Principal axes of a body whose inertia is known in other axes, where it has products of inertia.
import { ROUNDING } from '../components/inertia-tensor.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkKeys, checkNumber, type Vector } from '../errors/validate.ts';

/**
 * The tensor of inertia about the centre of mass, kg m². The products are elements of the tensor, with its minus sign:
 * xx = ∫(y² + z²) dm and xy = -∫x y dm. Some programs for construction list ∫x y dm instead; turn the sign around then.
 */
export interface TensorInput {
  readonly xx: number;
  readonly yy: number;
  readonly zz: number;
  /** Default 0. */
  readonly xy?: number;
  /** Default 0. */
  readonly xz?: number;
  /** Default 0. */
  readonly yz?: number;
}

/** What `spawn` takes for a body that is given by a tensor with products of inertia. */
export interface PrincipalAxes {
  /** The principal moments in ascending order, kg m²: `inertiaTensor` of the body. */
  readonly inertia: Vector;
  /**
   * The rotation that takes the x, y and z axes to the principal ones: `orientation` of a body that starts in the
   * attitude in which the tensor was given.
   */
  readonly orientation: { readonly w: number; readonly x: number; readonly y: number; readonly z: number };
}

/** Rows of a matrix. */
type Rows = [number[], number[], number[]];

/** Sweeps after which every tensor is diagonal; convergence is quadratic, and takes five or six. */
const SWEEPS = 30;

/** What does not change the moments: half a unit in the last place of the largest one, which is 1. */
const NEGLIGIBLE = 2 ** -54;

/**
 * The principal moments of inertia and the axes that they belong to, right-handed. Each axis has two senses: of the
 * first two the one is taken whose largest part is positive.
 *
 * Each rotation of the iteration clears one product of inertia; see Golub and Van Loan, Matrix Computations, section 8.5
 * (Jacobi's method).
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN; E_RANGE for a tensor that belongs to no body
 */
export function principalAxes(tensor: TensorInput): PrincipalAxes {
  const matrix = checkTensor(tensor);
  const largest = Math.max(matrix[0][0], matrix[1][1], matrix[2][2]);
  for (const row of matrix) for (let i = 0; i < 3; i++) row[i] /= largest;
  // In columns: the axes. They start as those of the tensor.
  const axes: Rows = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  for (let sweep = 0; sweep < SWEEPS && isCoupled(matrix); sweep++) {
    for (const [p, q] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ] as const)
      clearProduct(matrix, axes, p, q);
  }
  const order = [0, 1, 2].sort((a, b) => matrix[a][a] - matrix[b][b] || a - b);
  const [x, y, z] = order.map((i) => matrix[i][i] * largest);
  checkMoments({ x, y, z }, tensor);
  const first = facing(axes.map((row) => row[order[0]]));
  const second = facing(axes.map((row) => row[order[1]]));
  return { inertia: { x, y, z }, orientation: rotationTo(first, second) };
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
function checkTensor(tensor: TensorInput): Rows {
  checkKeys(tensor, 'principalAxes: tensor', ['xx', 'yy', 'zz', 'xy', 'xz', 'yz'], 'element');
  const { xx, yy, zz, xy = 0, xz = 0, yz = 0 } = tensor;
  for (const [name, value] of Object.entries({ xx, yy, zz })) {
    checkNumber(value, `tensor.${name}`, { above: 0, max: 1e38 });
  }
  for (const [name, value] of Object.entries({ xy, xz, yz })) {
    checkNumber(value, `tensor.${name}`, { min: -1e38, max: 1e38 });
  }
  return [
    [xx, xy, xz],
    [xy, yy, yz],
    [xz, yz, zz],
  ];
}

const isCoupled = (matrix: Rows) =>
  Math.max(Math.abs(matrix[0][1]), Math.abs(matrix[0][2]), Math.abs(matrix[1][2])) > 0;

/** Rotates the axes p and q of a symmetric matrix so that its element pq vanishes. */
function clearProduct(matrix: Rows, axes: Rows, p: number, q: number): void {
  const product = matrix[p][q];
  if (Math.abs(product) <= NEGLIGIBLE) {
    matrix[p][q] = matrix[q][p] = 0;
    return;
  }
  // Of the two angles the smaller one: its tangent t solves t² + 2 θ t = 1.
  const theta = (matrix[q][q] - matrix[p][p]) / (2 * product);
  const t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
  const c = 1 / Math.sqrt(t * t + 1);
  const s = t * c;
  const r = 3 - p - q;
  const [pr, qr] = [matrix[p][r], matrix[q][r]];
  matrix[p][p] -= t * product;
  matrix[q][q] += t * product;
  matrix[p][q] = matrix[q][p] = 0;
  matrix[p][r] = matrix[r][p] = c * pr - s * qr;
  matrix[q][r] = matrix[r][q] = s * pr + c * qr;
  for (const row of axes) {
    const [a, b] = [row[p], row[q]];
    row[p] = c * a - s * b;
    row[q] = s * a + c * b;
  }
}

/** The axis in the sense in which its largest part is positive; of equal ones the first counts. */
function facing(axis: readonly number[]): readonly number[] {
  const largest = axis.reduce((most, part) => (Math.abs(part) > Math.abs(most) ? part : most), 0);
  return largest < 0 ? axis.map((part) => -part) : axis;
}

/** @throws PhysicsError E_RANGE */
function checkMoments({ x, y, z }: Vector, tensor: TensorInput): void {
  const isPositive = x > 0;
  if (isPositive && z <= (x + y) * (1 + ROUNDING)) return;
  const fault = isPositive ? 'the largest exceeds the sum of the other two' : 'one is not positive';
  throw new PhysicsError(
    'E_RANGE',
    `the tensor belongs to no body: of its principal moments ${x}, ${y}, ${z} ${fault}.`,
    {
      field: 'tensor',
      value: tensor,
      hint: 'Give ∫(y² + z²) dm and so on about the centre of mass, and the products as -∫x y dm. A thin rod needs a thickness.',
    },
  );
}

/**
 * The quaternion of the rotation that takes x and y to two axes at right angles, and z to their cross product. Source:
 * Shepperd, Journal of Guidance and Control 1 (1978) 223: of the four parts the largest one is found from a root.
 */
function rotationTo(first: readonly number[], second: readonly number[]): PrincipalAxes['orientation'] {
  const [a, b, c] = first;
  const [d, e, f] = second;
  const third = [b * f - c * e, c * d - a * f, a * e - b * d];
  const [g, h, i] = third;
  const squares = [1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i];
  const parts = [
    [squares[0], f - h, g - c, b - d],
    [f - h, squares[1], d + b, g + c],
    [g - c, d + b, squares[2], h + f],
    [b - d, g + c, h + f, squares[3]],
  ][squares.indexOf(Math.max(...squares))];
  const norm = Math.sqrt(parts.reduce((sum, part) => sum + part * part, 0));
  const [w, x, y, z] = parts.map((part) => part / (parts[0] < 0 ? -norm : norm));
  return { w, x, y, z };
}
