/**
 * Stands for the builds of a precision that a game leaves out: the package's `imports` lead here under the export
 * condition `principia-f32` in the place of f64, and under `principia-f64` in the place of f32.
 */
export const BASE64 = '';
