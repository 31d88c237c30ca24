import type { SceneRun } from '@principia/scenes';

/** Another implementation of a scene's step. It starts from the same state and has its own memory. */
export interface Peer {
  readonly name: string;
  /** Takes one step of the scene's dt. */
  readonly step: () => void;
  /** Positions along an axis in the order of the bodies, to check that the work is the same. */
  readonly positions: (axis: 'x' | 'y' | 'z') => ArrayLike<number>;
  /** The peer does other work than ours, so its bodies end elsewhere. */
  readonly differs?: true;
}

/** Makes a peer for a scene before its first step; undefined if the peer cannot do the work of this run. */
export type PeerMaker = (run: SceneRun) => Peer | undefined | Promise<Peer | undefined>;
