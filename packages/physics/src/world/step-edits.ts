/** What edits of the running step leave for its end, so that rows do not change while systems run. */
export interface StepEdits {
  /** The edits, in the order of the calls. */
  readonly deferred: (() => void)[];
  /** What they will write to components that are completed from the values that they have (ecs/pending-values.ts). */
  readonly pending: Map<string, Record<string, number>>;
  /** Ids that lost Position through bitECS: their rows still hold the body that is gone. */
  readonly departed: Set<number>;
  /** Entities that are removed then, and an object of each that identifies its generation. */
  readonly leaving: Map<number, object>;
}

export function noEdits(): StepEdits {
  return { deferred: [], pending: new Map(), departed: new Set(), leaving: new Map() };
}
