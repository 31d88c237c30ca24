import { expect, test } from 'vitest';
import { createPhysicsWorld } from '../world/create-world.ts';
import { RESERVED_BYTES, TABLE_ADDRESS, TableColumn } from './column-table.ts';

test('the table of columns, the compiler’s constants and the first column do not overlap', () => {
  for (const precision of ['f32', 'f64'] as const) {
    const { kernels, addresses } = createPhysicsWorld({ precision, capacity: 1 });
    expect(TABLE_ADDRESS + 4 * TableColumn.end).toBeLessThanOrEqual(1024);
    expect(kernels.staticEnd()).toBeGreaterThanOrEqual(1024);
    expect(kernels.staticEnd()).toBeLessThanOrEqual(RESERVED_BYTES);
    expect(Math.min(...Object.values(addresses).flatMap((fields) => Object.values(fields)))).toBeGreaterThanOrEqual(
      RESERVED_BYTES,
    );
  }
});
