// Replaces `warnings.ts` under the export condition `production`, and checks nothing.
import type * as warnings from './warnings.ts';

export const printWarning: typeof warnings.printWarning = () => {};
export const warnAboutFaults: typeof warnings.warnAboutFaults = () => {};
export const warnAboutColor: typeof warnings.warnAboutColor = () => {};
export const warnAboutDuration: typeof warnings.warnAboutDuration = () => {};
export const warnAboutLimits: typeof warnings.warnAboutLimits = () => {};
export const warnAboutWorld: typeof warnings.warnAboutWorld = () => {};
