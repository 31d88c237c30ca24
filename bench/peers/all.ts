import { type Integrator, semiImplicitEuler, velocityVerlet } from '@principia/physics';
import { attractorsJs } from './attractors-js';
import { circlesJs } from './circles-js';
import { fusedJs } from './fused-js';
import { fusedSimd } from './fused-simd';
import { handWritten } from './hand-written';
import { inFlight } from './in-flight';
import { nBodyD3 } from './n-body-d3';
import { nBodyDirect } from './n-body-direct';
import { nBodyJs, nBodyPairsJs } from './n-body-js';
import type { PeerMaker } from './peer';
import { queryIdiom } from './query-idiom';
import { springsJs } from './springs-js';

/** Who is measured beside us, by scene. */
const PEERS: Readonly<Record<string, readonly PeerMaker[]>> = {
  particles: [
    ...[fusedSimd, handWritten, fusedJs, queryIdiom].map((make) => onlyWith(semiImplicitEuler, ofTwoLaws(make))),
    inFlight,
  ],
  springs: [onlyWith(semiImplicitEuler, springsJs)],
  attractors: [onlyWith(velocityVerlet, attractorsJs)],
  circles: [circlesJs],
  gas: [circlesJs],
  'nbody-direct': [nBodyJs, nBodyPairsJs],
  'nbody-tree': [nBodyDirect, nBodyD3],
};

/** A peer that can do the work of one integrator only. */
function onlyWith({ name }: Integrator, make: PeerMaker): PeerMaker {
  return (run) => (run.world.integrator.name === name ? make(run) : undefined);
}

/** A peer that knows the two laws of `particles` only. */
function ofTwoLaws(make: PeerMaker): PeerMaker {
  return (run) => (run.world.forces.length === 2 ? make(run) : undefined);
}

/** Makers of the peers of a scene. */
export function peersOf(scene: string): readonly PeerMaker[] {
  return PEERS[scene] ?? [];
}
