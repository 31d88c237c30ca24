// Where things are in the memory of the unpacker, which is its own. What is not written holds zeros, and pages that
// nothing touches cost nothing.

/** Contexts of a byte, and the inputs of the mixer: the contexts' guesses and a constant, in whole vectors. */
// @ts-ignore: decorator
@inline export const CONTEXTS: i32 = 11;
// @ts-ignore: decorator
@inline export const INPUTS: i32 = 12;
/** Weights of the mixer are the sum of three sets, each chosen by a byte. */
// @ts-ignore: decorator
@inline export const CHOICES: i32 = 3;

// @ts-ignore: decorator
@inline export const STRETCH: usize = 0x1000; // f32, 4096
// @ts-ignore: decorator
@inline export const SQUASH: usize = 0x5000; // f32, 1538
// @ts-ignore: decorator
@inline export const CONTEXT_SLOTS: usize = 0x7000; // address, CONTEXTS: where the slots of each begin
// @ts-ignore: decorator
@inline export const GUESSES: usize = 0x7200; // f32, INPUTS
// @ts-ignore: decorator
@inline export const HELD: usize = 0x7280; // i32, INPUTS: what the slots held
// @ts-ignore: decorator
@inline export const CHOSEN: usize = 0x72c0; // address, CHOICES: the sets of weights
// @ts-ignore: decorator
@inline export const OPERANDS: usize = 0x7300; // u8, 1024
// @ts-ignore: decorator
@inline export const BODIES: usize = 0xa000; // i32, 1024: where functions begin, and their first instruction
// @ts-ignore: decorator
@inline export const FIRST: usize = 0xb000; // i32, 1024
// @ts-ignore: decorator
@inline export const PLACES: usize = 0x10000; // i32, 65536
// @ts-ignore: decorator
@inline export const STARTS: usize = 0x50000; // i32, 65536: where instructions begin, and their families
// @ts-ignore: decorator
@inline export const FAMILIES: usize = 0x90000; // u8, 65536
// @ts-ignore: decorator
@inline export const HABITS: usize = 0xa0000; // u16, 32768: what came for a byte of the first build, and 1
// @ts-ignore: decorator
@inline export const CUSTOMS: usize = 0xb0000; // u16, 32768: what came after two instructions, and how often in a row
// @ts-ignore: decorator
@inline export const WEIGHTS: usize = 0xc0000; // f32, INPUTS a set, 256 sets a choice
// @ts-ignore: decorator
@inline export const SLOTS: usize = 0x100000; // i16, 2 to the power of SLOT_BITS a context
// @ts-ignore: decorator
@inline export const SLOT_BITS: i32 = 17;
/** The bytes of both builds, up to 128 KiB, and then the code they are packed in. */
// @ts-ignore: decorator
@inline export const BYTES: usize = SLOTS + (CONTEXTS << (SLOT_BITS + 1));
// @ts-ignore: decorator
@inline export const PACKED: usize = BYTES + 0x20000;
