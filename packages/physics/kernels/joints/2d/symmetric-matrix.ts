// A symmetric positive semidefinite matrix of n × n numbers, whose lower half is given by lines: L D Lᵀ of it, and solutions.
// Source: Golub and Van Loan, Matrix Computations, section 4.1.

// @ts-ignore: decorator
@inline function element(matrix: usize, n: i32, i: i32, j: i32): usize {
  return matrix + ((<usize>(i * n + j)) << 3);
}

// Replaces the lower half by L and, on the diagonal, the inverse of D, which is 0 where the matrix has no such direction.
export function factorSymmetric(matrix: usize, n: i32): void {
  for (let j = 0; j < n; j++) {
    const pivot = load<f64>(element(matrix, n, j, j));
    const inverse = pivot > 0 ? 1 / pivot : 0;
    store<f64>(element(matrix, n, j, j), inverse);
    for (let i = j + 1; i < n; i++) {
      const part = inverse * load<f64>(element(matrix, n, i, j));
      if (part == 0) continue;
      for (let k = j + 1; k <= i; k++) {
        const to = element(matrix, n, i, k);
        store<f64>(to, load<f64>(to) - part * load<f64>(element(matrix, n, k, j)));
      }
    }
    for (let i = j + 1; i < n; i++) {
      const to = element(matrix, n, i, j);
      store<f64>(to, inverse * load<f64>(to));
    }
  }
}

// Replaces n numbers, `stride` bytes apart, by the solution for them.
export function solveSymmetric(matrix: usize, n: i32, values: usize, stride: usize): void {
  for (let i = 0; i < n; i++) {
    const to = values + <usize>i * stride;
    for (let k = 0; k < i; k++)
      store<f64>(to, load<f64>(to) - load<f64>(element(matrix, n, i, k)) * load<f64>(values + <usize>k * stride));
  }
  for (let i = n - 1; i >= 0; i--) {
    const to = values + <usize>i * stride;
    store<f64>(to, load<f64>(to) * load<f64>(element(matrix, n, i, i)));
    for (let k = i + 1; k < n; k++)
      store<f64>(to, load<f64>(to) - load<f64>(element(matrix, n, k, i)) * load<f64>(values + <usize>k * stride));
  }
}
