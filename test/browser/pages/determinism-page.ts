import { chaosHashes } from '../../support/chaos.ts';
import { sceneHashes } from '../../support/scene-hashes.ts';

Object.assign(globalThis, { chaosHashes, sceneHashes });
