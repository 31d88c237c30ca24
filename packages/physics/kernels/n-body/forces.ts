// The mutual force on all bodies: directly, or by the tree with the error that was asked for.
import { get, put } from '../memory/columns';
import { direct2d, direct3d } from './direct';
import { evaluate2d } from './evaluate-2d';
import { evaluate3d } from './evaluate-3d';
import { directOntoTests, sampleError } from './field';
import { middleOf } from './approximate-median';
import { buildTree } from './tree';
import { boundGroup, fieldScale, walkGroup } from './interaction-lists';
import { NBody } from './workspace';

// A group whose field nearly cancels is given this share of the median field: the error there is small against the
// errors elsewhere, and the walk would open everything.
const LEAST_SHARE: f64 = 0.1;

// Evaluations between two looks at the error, and the bodies it is measured at, others at each look; twice as many at
// the first. A look costs about one evaluation more.
const LOOK_EVERY: i32 = 32;
const LOOK_AT: i32 = 512;

// Share of the error asked for that the tree is steered to, and by how much it may be off. Errors of single bodies have
// a long tail: of galaxies of 60 000 stars, one look in forty at a thousand of them sees a third more than the mean.
const AIM: f64 = 0.62;
const SLACK: f64 = 0.08;

// Weight of the newest look in what is known of the error: one alone is off by a tenth.
const NEWS: f64 = 0.3;

// Tolerance over relative error that Plummer spheres, uniform boxes and discs need on average.
const CALIBRATION: f64 = 6;

// Builds the tree of the packed bodies if it is not built; `law` is 2 for 1/r², 1 for 1/r.
export function prepareTree(w: NBody, dimensions: i32, law: i32): void {
  if (w.treeValid != 0 || w.bodies == 0) return;
  buildTree(w, dimensions, law == 2 ? 3 : 2);
  for (let g = 0; g < w.groupCount; g++) {
    const at = w.groups + ((<usize>g) << 3);
    boundGroup(w, load<i32>(at), load<i32>(at, 4));
    put(w.groupFields, g, fieldScale(w, law == 2));
  }
  const least = <real>(LEAST_SHARE * middleOf(w.counts, w.groupFields, sizeof<real>(), w.groupCount));
  for (let g = 0; g < w.groupCount; g++) put(w.groupFields, g, max<real>(least, get(w.groupFields, g)));
}

// Fills the lists of group `g`.
export function listGroup(w: NBody, g: i32, law: i32): void {
  const at = w.groups + ((<usize>g) << 3);
  boundGroup(w, load<i32>(at), load<i32>(at, 4));
  walkGroup(w, <real>(w.tolerance * <f64>get(w.groupFields, g)), law == 2);
}

// Accelerations of all bodies, in tree order. `signed`: strengths of both signs, so that cells have dipoles.
function treeForces(w: NBody, dimensions: i32, law: i32, signed: bool): void {
  let cellPairs: f64 = 0;
  let bodyPairs: f64 = 0;
  for (let g = 0; g < w.groupCount; g++) {
    const at = w.groups + ((<usize>g) << 3);
    const first = load<i32>(at);
    const last = load<i32>(at, 4);
    listGroup(w, g, law);
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

// Adds a look's mean square error to what is known. One beyond the demand is believed by itself: bodies have moved.
function learn(w: NBody, square: f64, wanted: f64): void {
  const known = w.meanSquare;
  w.meanSquare = known > 0 && square < wanted * wanted ? known + NEWS * (square - known) : square;
}

// Changes the tolerance by what is known of the error, which grows roughly as its 2/3 power.
function steer(w: NBody, wanted: f64): void {
  const ratio = (AIM * wanted) / max<f64>(sqrt<f64>(w.meanSquare), 1e-300);
  if (abs<f64>(ratio - 1) < SLACK) return;
  const change = min<f64>(1.6, max<f64>(0.07, ratio));
  w.tolerance = min<f64>(w.tolerance * change * sqrt<f64>(change), 100);
  w.meanSquare *= change * change;
}

function byTree(w: NBody, dimensions: i32, law: i32, signed: bool, relativeError: f64): void {
  prepareTree(w, dimensions, law);
  if (w.tolerance == 0) w.tolerance = CALIBRATION * relativeError;
  const look = relativeError > 0 && w.evaluations % LOOK_EVERY == 0;
  treeForces(w, dimensions, law, signed);
  if (!look) return;
  const samples = w.meanSquare > 0 ? LOOK_AT : 2 * LOOK_AT;
  for (let attempt = 0; attempt < 8; attempt++) {
    w.error = sampleError(w, samples, w.evaluations / LOOK_EVERY, law == 2);
    learn(w, w.error * w.error, relativeError);
    steer(w, relativeError);
    if (w.error <= 0.85 * relativeError) return;
    treeForces(w, dimensions, law, signed);
    w.evaluations--;
  }
}

// Evaluates the packed bodies, unless the results are still those of the same bodies at the same places.
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
    byTree(w, dimensions, law, signed != 0, relativeError);
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

// RMS relative error of the results at up to 1024 bodies.
export function nBodyError(address: usize, law: i32, samples: i32): f64 {
  const w = changetype<NBody>(address);
  return sampleError(w, samples, 0, law == 2);
}
