// The reserved ranges at the start of a world's memory, by ascending address. Each range ends where the next begins.
// The build of the kernels checks that the contents of a range fit, and writes the addresses for TypeScript into
// src/memory/layouts.gen.ts. The bytes before the first range stay zero, so that a read through a null address gives 0.

// The addresses of columns: class Columns.
export const COLUMN_TABLE: usize = 64;

// Two bodies of particle-contacts/body.ts for walls, which have no contacts table: row 0, which belongs to no entity and
// holds zeros, and the body at the wall.
export const WALL_BODIES: usize = 512;

// The constants that the compiler puts into memory for each module: kernels/index.ts, then every <feature>/module.ts.
export const CORE_CONSTANTS: usize = 1024;
export const EMITTERS_CONSTANTS: usize = 1536;
export const FORCES_CONSTANTS: usize = 1664;
export const INTEGRATORS_CONSTANTS: usize = 1792;
export const MATH_CONSTANTS: usize = 2048;
export const N_BODY_CONSTANTS: usize = 2304;
export const PARTICLE_CONTACTS_CONSTANTS: usize = 2560;
export const SOFT_BODIES_CONSTANTS: usize = 3072;
export const XPBD_CONSTANTS: usize = 3584;
export const RIGID_2D_CONSTANTS: usize = 4096;
export const ROTATION_CONSTANTS: usize = 12192;

// Where columns begin.
export const FIRST_COLUMN: usize = 12416;
