// d3-force's forceManyBody, the Barnes-Hut quadtree known from browsers, on the stars of `nbody-tree` in 2D with the
// law 1/r, the only law that it supports. It has no softening, but a minimum distance. Theta has its default of 0.9;
// its error against direct summation is measured at creation and shown with its name.
import type { ClusterRun, SceneRun } from '@principia/scenes';
import { forceManyBody, type SimulationNodeDatum } from 'd3-force';
import { median } from '../statistics.ts';
import { kick, kickDrift, type NBodyState, nBodyState } from './n-body-columns.ts';
import type { Peer } from './peer.ts';

const THETA = 0.9;
const SAMPLES = 1000;

interface Node extends SimulationNodeDatum {
  index: number;
  x: number;
  y: number;
  vx: number;
  vy: number;
}

/** Undefined for another law. */
export function nBodyD3(run: SceneRun): Peer | undefined {
  if (run.world.dimensions !== 2 || (run as ClusterRun).law !== 'inverse-distance') return undefined;
  const state = nBodyState(run);
  const nodes = Array.from({ length: state.count }, (_, index): Node => ({ index, x: 0, y: 0, vx: 0, vy: 0 }));
  const force = forceManyBody<Node>()
    .strength((_, i) => state.G * state.mass[i])
    .theta(THETA)
    .distanceMin(state.softening);
  force.initialize?.(nodes, Math.random);
  const pull = () => pullBy(force, nodes, state);
  pull();
  const percent = (100 * errorOf(state)).toFixed(2);
  return {
    name: `d3-force many-body, θ ${THETA}, RMS error ${percent} %`,
    step() {
      kickDrift(state);
      pull();
      kick(state);
    },
    positions: (axis) => state.x[axis],
  };
}

function pullBy(force: (alpha: number) => void, nodes: Node[], { x, a }: NBodyState): void {
  for (let i = 0; i < nodes.length; i++) {
    const node = nodes[i];
    node.x = x.x[i];
    node.y = x.y[i];
    node.vx = 0;
    node.vy = 0;
  }
  force(1);
  for (let i = 0; i < nodes.length; i++) {
    a.x[i] = nodes[i].vx;
    a.y[i] = nodes[i].vy;
  }
}

/**
 * RMS relative error by d3's rule for close pairs; forces below a tenth of the median count as a tenth of the median.
 */
function errorOf({ count, G, softening, x: { x, y }, mass, a }: NBodyState): number {
  const samples = Math.min(SAMPLES, count);
  const off: number[] = [];
  const size: number[] = [];
  for (let k = 0; k < samples; k++) {
    const i = Math.floor(((k + 0.5) * count) / samples);
    let ax = 0;
    let ay = 0;
    for (let j = 0; j < count; j++) {
      const [dx, dy] = [x[j] - x[i], y[j] - y[i]];
      const square = dx * dx + dy * dy;
      if (square === 0) continue;
      const u = Math.max(square, Math.sqrt(square) * softening);
      ax += (G * mass[j] * dx) / u;
      ay += (G * mass[j] * dy) / u;
    }
    off.push(Math.hypot(ax - a.x[i], ay - a.y[i]));
    size.push(Math.hypot(ax, ay));
  }
  const least = 0.1 * median(size);
  const squares = off.map((value, k) => (value / Math.max(size[k], least)) ** 2);
  return Math.sqrt(squares.reduce((sum, value) => sum + value, 0) / samples);
}
