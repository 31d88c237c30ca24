/** The arithmetic-geometric mean, to which elliptic integrals reduce: K(k) = π / (2 agM(1, √(1 − k²))). */
export function agm(first: number, second: number): number {
  let [a, b] = [first, second];
  // Each round doubles the correct digits.
  for (let i = 0; i < 8; i++) [a, b] = [(a + b) / 2, Math.sqrt(a * b)];
  return a;
}
