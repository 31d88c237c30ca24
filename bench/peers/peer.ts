import type { SceneRun } from '@principia/scenes';

/** Somebody else's way to do the work of a scene's step. It starts from the same state and keeps its own memory. */
export interface Peer {
  readonly name: string;
  /** One step of the scene's dt. */
  readonly step: () => void;
  /** The position along an axis in bodies' order, to see that it did the same work. */
  readonly positions: (axis: 'x' | 'y' | 'z') => ArrayLike<number>;
  /** It does other work than ours, and its bodies go other ways: less of it, say, or none of the walls. */
  readonly differs?: true;
}

/** Makes a peer from a scene just made; nothing has stepped yet. None where it cannot do this run's work. */
export type PeerMaker = (run: SceneRun) => Peer | Promise<Peer> | undefined;
