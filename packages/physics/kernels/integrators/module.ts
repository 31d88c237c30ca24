// The schemes of many stages: a module of its own, so that a game without them does not pay.
export { accelerationAxis, addScaledColumn, combineAxis, implicitResidualAxis, scaleColumn } from './combine';
export { embeddedErrorAxis, worstError } from './embedded-error';
export {
  radauBegin,
  radauEnd,
  radauForget,
  radauLargest,
  radauLargestOf,
  radauPredict,
  radauRefine,
  radauState,
  radauWorstRow,
} from './radau';
export { driftKepler, fromJacobi, gatherPlanets, kickJacobi, toJacobi } from './wisdom-holman';
