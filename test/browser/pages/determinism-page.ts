import { chaosHashes } from '../../support/chaos.ts';

Object.assign(globalThis, { chaosHashes });
