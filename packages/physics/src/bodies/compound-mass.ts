// Mass properties of compound bodies: the sums over the parts, by the parallel-axis theorem.
//
//   m = Σ mᵢ        c = Σ mᵢ rᵢ / m        I = Σ (Iᵢ + mᵢ |rᵢ - c|²)
//
//   mᵢ, rᵢ, Iᵢ  mass, centre of mass and moment of inertia about it of each part. Source: Goldstein, Classical Mechanics,
//   section 5.3 (Steiner's theorem). Parts that overlap count twice where they do.

/** A part as far as its mass matters: its centre in the coordinates of the compound, m, and what it weighs. */
export interface MassPart {
  readonly x: number;
  readonly y: number;
  /** Mass, kg, or what the mass is proportional to. */
  readonly mass: number;
  /** Moment of inertia about its own centre for each unit of mass, m². */
  readonly inertiaPerMass: number;
}

/** Mass, centre, and moment of inertia about the centre. */
export interface CompoundMass {
  readonly mass: number;
  readonly x: number;
  readonly y: number;
  readonly inertia: number;
}

/** The mass properties of parts together. Without mass the centre is the origin. */
export function compoundMass(parts: readonly MassPart[]): CompoundMass {
  const mass = parts.reduce((sum, part) => sum + part.mass, 0);
  if (!(mass > 0)) return { mass: 0, x: 0, y: 0, inertia: 0 };
  const x = parts.reduce((sum, part) => sum + part.mass * part.x, 0) / mass;
  const y = parts.reduce((sum, part) => sum + part.mass * part.y, 0) / mass;
  const inertia = parts.reduce((sum, part) => {
    const [dx, dy] = [part.x - x, part.y - y];
    return sum + part.mass * (part.inertiaPerMass + dx * dx + dy * dy);
  }, 0);
  return { mass, x, y, inertia };
}
