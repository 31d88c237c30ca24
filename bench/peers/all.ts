import type { SceneRun } from '@principia/scenes';
import { attractorsJs } from './attractors-js';
import { circlesJs } from './circles-js';
import { fusedJs } from './fused-js';
import { fusedSimd } from './fused-simd';
import { nBodyD3 } from './n-body-d3';
import { nBodyDirect } from './n-body-direct';
import { nBodyJs } from './n-body-js';
import type { Peer, PeerMaker } from './peer';
import { queryIdiom } from './query-idiom';
import { springsJs } from './springs-js';

/** Who is measured beside us, by scene. */
const PEERS: Readonly<Record<string, readonly PeerMaker[]>> = {
  particles: [fusedSimd, fusedJs, queryIdiom],
  springs: [springsJs],
  attractors: [attractorsJs],
  gas: [circlesJs],
  'nbody-direct': [nBodyJs],
  'nbody-tree': [nBodyDirect, nBodyD3],
};

/** The peers of a scene, ready to take the first step from the state `run` is in. */
export async function makePeers(scene: string, run: SceneRun): Promise<Peer[]> {
  const peers: Peer[] = [];
  for (const make of PEERS[scene] ?? []) {
    const peer = await make(run);
    if (peer !== undefined) peers.push(peer);
  }
  return peers;
}
