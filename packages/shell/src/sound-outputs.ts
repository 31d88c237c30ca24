/** What a page plays, so that a clip of it has its sound. */

import { isPreview } from './preview.ts';

const outputs = new Set<AudioNode>();

/** Connects the last node of a chain to the loudspeakers, and lets clips record it; a preview is silent. */
export function connectToSpeakers(node: AudioNode): void {
  if (isPreview) return;
  forgetClosed();
  node.connect(node.context.destination);
  outputs.add(node);
}

/** A sound track that is being recorded. */
export interface SoundTrack {
  readonly track: MediaStreamTrack;
  /** Ends the track and lets go of the sounds. */
  stop(): void;
}

/** Mixes what the page plays into one track; undefined where nothing plays, or where the browser refuses. */
export function openSoundTrack(): SoundTrack | undefined {
  forgetClosed();
  // A context that is suspended sends no samples at all, for which some encoders wait forever.
  const heard = [...outputs].filter(({ context }) => context.state === 'running');
  const mixer = heard[0]?.context as AudioContext | undefined;
  if (mixer === undefined) return undefined;
  const undo: (() => void)[] = [];
  try {
    const mix = mixer.createMediaStreamDestination();
    for (const node of heard) undo.push(lead(node, mixer, mix));
    const [track] = mix.stream.getAudioTracks();
    undo.push(() => track.stop());
    return { track, stop: () => runAll(undo) };
  } catch {
    runAll(undo);
    return undefined;
  }
}

function runAll(actions: readonly (() => void)[]): void {
  for (const action of actions) action();
}

/** Leads a sound into the mix, by a stream if it belongs to another context. @returns how to undo it */
function lead(node: AudioNode, mixer: AudioContext, mix: AudioNode): () => void {
  if (node.context === mixer) {
    node.connect(mix);
    return () => node.disconnect(mix);
  }
  const bridge = (node.context as AudioContext).createMediaStreamDestination();
  node.connect(bridge);
  const arriving = mixer.createMediaStreamSource(bridge.stream);
  arriving.connect(mix);
  return () => {
    node.disconnect(bridge);
    arriving.disconnect();
    for (const track of bridge.stream.getTracks()) track.stop();
  };
}

/** A page that starts and stops games would keep the sounds of all of them. */
function forgetClosed(): void {
  for (const node of outputs) if (node.context.state === 'closed') outputs.delete(node);
}
