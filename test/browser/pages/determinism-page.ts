import { chaosHashes } from '../../support/chaos.ts';
import { hingeHashes } from '../../support/falling-hinges.ts';
import { sceneHashes } from '../../support/scene-hashes.ts';

Object.assign(globalThis, { chaosHashes, hingeHashes, sceneHashes });
