// Replaces `warnings.ts` under the export condition `production`, and checks nothing.
import type * as warnings from './warnings.ts';

export const printWarning: typeof warnings.printWarning = () => {};
export const notePartRemoved: typeof warnings.notePartRemoved = () => {};
export const warnAboutDeadRef: typeof warnings.warnAboutDeadRef = () => {};
export const warnAboutImpulse: typeof warnings.warnAboutImpulse = () => {};
export const warnAboutFreePin: typeof warnings.warnAboutFreePin = () => {};
export const warnAboutColumns: typeof warnings.warnAboutColumns = () => {};
export const warnAboutFaults: typeof warnings.warnAboutFaults = () => {};
export const warnAboutColor: typeof warnings.warnAboutColor = () => {};
export const warnAboutDuration: typeof warnings.warnAboutDuration = () => {};
export const warnAboutJoint: typeof warnings.warnAboutJoint = () => {};
export const warnAboutWallContacts: typeof warnings.warnAboutWallContacts = () => {};
export const warnAboutWorld: typeof warnings.warnAboutWorld = () => {};
