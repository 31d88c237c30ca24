import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { expect, test } from 'vitest';
import { connectToSpeakers } from './sound-outputs.ts';

setFlagsFromString('--expose-gc');
const collectGarbage = runInNewContext('gc') as () => void;

/** The last node of a chain, and its context. */
function makeSound() {
  const context = { state: 'running', destination: {} };
  const node = { context, connect() {} };
  return { context, node: node as unknown as AudioNode };
}

/** Plays a sound and closes its context; nothing but what is returned knows of it. */
function playBriefly(): WeakRef<object> {
  const { context, node } = makeSound();
  connectToSpeakers(node);
  context.state = 'closed';
  return new WeakRef(node);
}

test('sounds of a game that has stopped are let go when the next game plays', async () => {
  const first = playBriefly();
  connectToSpeakers(makeSound().node);
  await new Promise((done) => setTimeout(done));
  collectGarbage();
  expect(first.deref()).toBeUndefined();
});
