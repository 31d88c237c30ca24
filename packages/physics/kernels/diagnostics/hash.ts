// A 64-bit hash of columns: FNV-1a over 32-bit words (Fowler, Noll, Vo), mixed by a xor-shift so that high bits affect
// low bits. Not cryptographic; equal states give equal hashes on every machine.

const PRIME: u64 = 0x100000001b3;

// @ts-ignore: decorator
@inline function mix(hash: u64, word: u32): u64 {
  const h = (hash ^ <u64>word) * PRIME;
  return h ^ (h >> 29);
}

let state: u64 = 0;

export function hashBegin(): void {
  state = 0xcbf29ce484222325;
}

// Adding 0 to every value makes -0 and 0 hash alike; every NaN hashes as one value.
export function hashReals(column: usize, rows: i32): void {
  let h = state;
  for (let row = 0; row < rows; row++) {
    const value = load<real>(column + <usize>row * sizeof<real>()) + <real>0;
    if (sizeof<real>() == 4) {
      h = mix(h, value == value ? reinterpret<u32>(<f32>value) : 0x7fc00000);
    } else {
      const bits = value == value ? reinterpret<u64>(<f64>value) : 0x7ff8000000000000;
      h = mix(mix(h, <u32>bits), <u32>(bits >> 32));
    }
  }
  state = h;
}

export function hashWords(column: usize, rows: i32): void {
  let h = state;
  for (let row = 0; row < rows; row++) h = mix(h, load<u32>(column + ((<usize>row) << 2)));
  state = h;
}

export function hashLow(): u32 {
  return <u32>state;
}

export function hashHigh(): u32 {
  return <u32>(state >> 32);
}
