import { chaosHashes } from '../../support/chaos.ts';
import { hingeHashes } from '../../support/falling-hinges.ts';

Object.assign(globalThis, { chaosHashes, hingeHashes });
