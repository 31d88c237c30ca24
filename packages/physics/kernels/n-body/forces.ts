// The mutual force on all bodies: directly, or by the tree to the requested error.
import { get, put } from '../memory/columns';
import { direct2d, direct3d } from './direct';
import { evaluate2d } from './evaluate-2d';
import { evaluate3d } from './evaluate-3d';
import { directOntoTests, sampleError } from './field';
import { approximateMedian } from './approximate-median';
import { buildTree } from './tree';
import { boundGroup, fieldScale, listInteractions } from './interaction-lists';
import { NBody } from './workspace';

// A group in a weak field is given at least this fraction of the median field. Its error there is small compared with
// the errors elsewhere, and the traversal would otherwise open every cell.
const MIN_FIELD_FRACTION: f64 = 0.1;

// Evaluations between two error measurements, and the bodies sampled, which differ each time and are twice as many at
// the first. A measurement costs about one additional evaluation.
const SAMPLE_INTERVAL: i32 = 32;
const SAMPLE_COUNT: i32 = 512;

// Fraction of the requested error that the control aims at, and the permitted deviation. Errors of single bodies have a
// long tail: for galaxies of 60 000 stars, one measurement in forty at a thousand stars is a third above the mean.
const TARGET_FRACTION: f64 = 0.62;
const TARGET_TOLERANCE: f64 = 0.08;

// Weight of the latest measurement in the running estimate; a single measurement is off by a tenth.
const LATEST_WEIGHT: f64 = 0.3;

// Fractions of the requested error: above the first an evaluation is repeated with a smaller tolerance, and below the
// second with a larger one, up to LOOSER_ATTEMPTS times.
const WITHIN: f64 = 0.85;
const FAR_WITHIN: f64 = 0.3;
const LOOSER_ATTEMPTS: i32 = 3;

const MAX_TOLERANCE: f64 = 100;

// Mean ratio of tolerance to relative error for Plummer spheres, uniform boxes and discs.
const CALIBRATION: f64 = 6;

// Builds the tree of the packed bodies unless it is valid; `law` is 2 for 1/r², 1 for 1/r.
export function prepareTree(w: NBody, dimensions: i32, law: i32): void {
  if (w.treeValid != 0 || w.bodies == 0) return;
  buildTree(w, dimensions, law == 2 ? 3 : 2);
  for (let g = 0; g < w.groupCount; g++) {
    const at = w.groups + ((<usize>g) << 3);
    boundGroup(w, load<i32>(at), load<i32>(at, 4));
    put(w.groupFields, g, fieldScale(w, law == 2));
  }
  const median = approximateMedian(w.counts, w.groupFields, sizeof<real>(), w.groupCount);
  const minField = <real>(MIN_FIELD_FRACTION * median);
  for (let g = 0; g < w.groupCount; g++) put(w.groupFields, g, max<real>(minField, get(w.groupFields, g)));
}

// Builds the interaction lists of group `g`.
export function listGroupInteractions(w: NBody, g: i32, law: i32): void {
  const at = w.groups + ((<usize>g) << 3);
  boundGroup(w, load<i32>(at), load<i32>(at, 4));
  listInteractions(w, <real>(w.tolerance * <f64>get(w.groupFields, g)), law == 2);
}

// Computes the accelerations of all bodies, in tree order. `signed` means that strengths have both signs, so that cells
// have dipoles.
function treeForces(w: NBody, dimensions: i32, law: i32, signed: bool): void {
  let cellPairs: f64 = 0;
  let bodyPairs: f64 = 0;
  for (let g = 0; g < w.groupCount; g++) {
    const at = w.groups + ((<usize>g) << 3);
    const first = load<i32>(at);
    const last = load<i32>(at, 4);
    listGroupInteractions(w, g, law);
    const count = <f64>(last - first);
    cellPairs += count * <f64>w.cellCount;
    bodyPairs += count * <f64>w.listedBodies;
    if (dimensions == 3) evaluate3d(w, first, last, signed);
    else evaluate2d(w, first, last, law == 2, signed);
  }
  w.cellPairs = cellPairs;
  w.bodyPairs = bodyPairs;
  w.evaluations++;
}

// Adds a measured mean square error to the estimate. A measurement above the requested error replaces the estimate,
// because the bodies have moved.
function updateErrorEstimate(w: NBody, square: f64, requestedError: f64): void {
  const estimate = w.meanSquare;
  const isWithin = estimate > 0 && square < requestedError * requestedError;
  w.meanSquare = isWithin ? estimate + LATEST_WEIGHT * (square - estimate) : square;
}

// Adjusts the tolerance by the estimated error, which grows roughly as the 2/3 power of the tolerance.
function adjustTolerance(w: NBody, requestedError: f64): void {
  const ratio = (TARGET_FRACTION * requestedError) / max<f64>(sqrt<f64>(w.meanSquare), 1e-300);
  if (abs<f64>(ratio - 1) < TARGET_TOLERANCE) return;
  const change = min<f64>(1.6, max<f64>(0.07, ratio));
  w.tolerance = min<f64>(w.tolerance * change * sqrt<f64>(change), MAX_TOLERANCE);
  w.meanSquare *= change * change;
}

function evaluateAgain(w: NBody, dimensions: i32, law: i32, signed: bool): void {
  treeForces(w, dimensions, law, signed);
  w.evaluations--;
}

// Raises a tolerance that is far too small, `passed`, as far as the measured error allows it. The estimate is of no use
// here: where the bodies are clumped, the error depends on the tolerance in another way than that of adjustTolerance.
function loosen(w: NBody, dimensions: i32, law: i32, signed: bool, relativeError: f64, passed: f64): void {
  const choice = w.evaluations / SAMPLE_INTERVAL;
  let failed: f64 = Infinity;
  let evaluated = passed;
  for (let attempt = 0; attempt < LOOSER_ATTEMPTS && w.error < FAR_WITHIN * relativeError; attempt++) {
    const change = min<f64>(4, (TARGET_FRACTION * relativeError) / max<f64>(w.error, 1e-300));
    const looser = min<f64>(passed * change * sqrt<f64>(change), MAX_TOLERANCE);
    const next = looser < failed ? looser : sqrt<f64>(passed * failed);
    if (next < 1.25 * passed) break;
    w.tolerance = evaluated = next;
    evaluateAgain(w, dimensions, law, signed);
    const error = sampleError(w, 2 * SAMPLE_COUNT, choice, law == 2);
    if (error <= WITHIN * relativeError) {
      passed = next;
      w.error = error;
    } else {
      failed = next;
    }
  }
  w.tolerance = passed;
  if (evaluated != passed) evaluateAgain(w, dimensions, law, signed);
  w.meanSquare = w.error * w.error;
}

function evaluateByTree(w: NBody, dimensions: i32, law: i32, signed: bool, relativeError: f64): void {
  prepareTree(w, dimensions, law);
  if (w.tolerance == 0) w.tolerance = CALIBRATION * relativeError;
  const measuresError = relativeError > 0 && w.evaluations % SAMPLE_INTERVAL == 0;
  treeForces(w, dimensions, law, signed);
  if (!measuresError) return;
  const samples = w.meanSquare > 0 ? SAMPLE_COUNT : 2 * SAMPLE_COUNT;
  for (let attempt = 0; attempt < 8; attempt++) {
    const used = w.tolerance;
    w.error = sampleError(w, samples, w.evaluations / SAMPLE_INTERVAL, law == 2);
    updateErrorEstimate(w, w.error * w.error, relativeError);
    adjustTolerance(w, relativeError);
    if (w.error < FAR_WITHIN * relativeError) loosen(w, dimensions, law, signed, relativeError, used);
    if (w.error <= WITHIN * relativeError) return;
    evaluateAgain(w, dimensions, law, signed);
  }
}

// Evaluates the packed bodies, unless the results are still valid.
export function nBodyEvaluate(
  address: usize,
  dimensions: i32,
  law: i32,
  signed: i32,
  useTree: i32,
  relativeError: f64,
): void {
  const w = changetype<NBody>(address);
  if (w.resultsValid != 0 && w.resultsByTree == useTree) return;
  w.resultsByTree = useTree;
  w.resultsValid = 1;
  if (w.bodies == 0) return;
  if (useTree != 0) {
    evaluateByTree(w, dimensions, law, signed != 0, relativeError);
    return;
  }
  if (dimensions == 3) direct3d(w);
  else direct2d(w, law == 2);
  directOntoTests(w, law == 2);
  w.cellPairs = 0;
  w.bodyPairs = 0.5 * <f64>w.sources * <f64>(w.sources - 1) + <f64>w.sources * <f64>(w.end - w.tests);
  w.error = 0;
  w.evaluations++;
}

// Returns the RMS relative error of the results at up to 1024 bodies.
export function nBodyError(address: usize, law: i32, samples: i32): f64 {
  const w = changetype<NBody>(address);
  return sampleError(w, samples, 0, law == 2);
}
