import { type Integrator, semiImplicitEuler, velocityVerlet } from '@principia/physics';
import { attractorsJs } from './attractors-js.ts';
import { circlesJs } from './circles-js.ts';
import { fusedJs } from './fused-js.ts';
import { fusedSimd } from './fused-simd.ts';
import { handWritten } from './hand-written.ts';
import { inFlight } from './in-flight.ts';
import { nBodyD3 } from './n-body-d3.ts';
import { nBodyDirect } from './n-body-direct.ts';
import { nBodyJs, nBodyPairsJs } from './n-body-js.ts';
import type { PeerMaker } from './peer.ts';
import { queryIdiom } from './query-idiom.ts';
import { box2dPeer, box2dSimdPeer } from './rigid/box2d-peer.ts';
import { planckPeer } from './rigid/planck-peer.ts';
import { rapierPeer } from './rigid/rapier-peer.ts';
import { springsJs } from './springs-js.ts';

/** Other engines. */
const ENGINES: readonly PeerMaker[] = [box2dPeer, box2dSimdPeer, rapierPeer, planckPeer];

/** The peers of each scene. */
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
  pyramid: ENGINES,
  'many-pyramids': ENGINES,
  'joint-grid': ENGINES,
  tumbler: ENGINES,
  washer: ENGINES,
  discs: ENGINES,
  smash: ENGINES,
  'elastic-discs': ENGINES,
  chains: ENGINES,
};

/** A peer that supports a single integrator. */
function onlyWith({ name }: Integrator, make: PeerMaker): PeerMaker {
  return (run) => (run.world.integrator.name === name ? make(run) : undefined);
}

/** A peer that supports only the two laws of `particles`. */
function ofTwoLaws(make: PeerMaker): PeerMaker {
  return (run) => (run.world.forces.length === 2 ? make(run) : undefined);
}

/** Makers of the peers of a scene. */
export function peersOf(scene: string): readonly PeerMaker[] {
  return PEERS[scene] ?? [];
}
