// Every loop over bodies that runs each step, compiled once for f32 and once for f64.
export * from './ecs/membership';
export * from './ecs/zero-missing';
export * from './dynamics/flush-to-zero';
export * from './dynamics/save-and-validate';
export * from './diagnostics/hash';
export * from './diagnostics/energy';
export * from './forces/springs';
export * from './forces/attractors';
export * from './dynamics/drift-kick';
export * from './dynamics/integrate-rotation';
export { boxListed, boxRows } from './particle-contacts/walls/box';
export * from './snapshot/pages';
