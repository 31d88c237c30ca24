// Every loop over bodies that runs each step, compiled once for f32 and once for f64.
export * from './membership';
export * from './absent';
export * from './pose';
export * from './hash';
export * from './diagnostics';
export * from './forces/springs';
export * from './forces/attractors';
export * from './integrators/stages';
export * from './integrators/spin';
export * from './walls/box';
export * from './pages';
export { staticEnd } from './columns';
