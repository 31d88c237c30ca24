// Stands in for `warnings.ts` under the export condition `production`: no checks, no texts.
import type * as warnings from './warnings.ts';

export const warnOnce: typeof warnings.warnOnce = () => {};
export const printWarning: typeof warnings.printWarning = () => {};
export const warnAboutDuration: typeof warnings.warnAboutDuration = () => {};
export const warnAboutWorld: typeof warnings.warnAboutWorld = () => {};
