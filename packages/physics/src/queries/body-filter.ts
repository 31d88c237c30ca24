// Which bodies a query sees.
import { BITS_HINT } from '../components/collider.ts';
import { checkFlag, checkWhole } from '../errors/validate.ts';

/** Bodies that a query sees. */
export interface BodyFilter {
  /** Layers, one bit each: bodies that are on none of them are left out. Default all. */
  readonly mask?: number;
  /** A body, with its parts, or a wall that is left out, such as the one that asks; or a list of them. Default none. */
  readonly ignore?: number | readonly number[];
  /** Whether sensors are seen; default false. */
  readonly sensors?: boolean;
}

/** A filter whose options are valid. */
export interface CheckedFilter {
  readonly mask: number;
  readonly ignored: readonly number[];
  readonly seesSensors: boolean;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE */
export function checkBodyFilter({ mask = 0xffffffff, ignore = [], sensors }: BodyFilter): CheckedFilter {
  return {
    mask: checkWhole(mask, 'mask', 0, 0xffffffff, BITS_HINT),
    ignored: checkIds(ignore),
    seesSensors: checkFlag(sensors, 'sensors'),
  };
}

function checkIds(ignore: number | readonly number[]): readonly number[] {
  const ids = Array.isArray(ignore) ? (ignore as readonly number[]) : [ignore as number];
  return ids.map((id) => checkWhole(id, 'ignore', 0, 0xffffffff)).filter((id) => id > 0);
}
