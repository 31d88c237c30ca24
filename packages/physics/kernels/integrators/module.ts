// Kernels of multi-stage schemes, in a separate module to keep other bundles small.
export { accelerationAxis, addScaledColumn, combineAxis, implicitResidualAxis, scaleColumn } from './combine';
export { embeddedErrorAxis, worstError } from './embedded-error';
export {
  radauBegin,
  radauEnd,
  radauReset,
  radauLargest,
  radauLargestOf,
  radauPredict,
  radauRefine,
  radauState,
  radauWorstRow,
} from './radau';
export { driftKepler, fromJacobi, gatherPlanets, kickJacobi, toJacobi } from './wisdom-holman';
