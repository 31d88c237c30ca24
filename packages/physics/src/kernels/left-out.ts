/**
 * Replaces the builds of an omitted precision: the package's `imports` resolve to this file for f64 under the export
 * condition `principia-f32`, and for f32 under `principia-f64`.
 */
export const HEX = '';
