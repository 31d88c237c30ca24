// An impact where the bodies are when the step ends. Levers in a block are of its start; impulses that act at them after the bodies have
// gone on would make angular momentum.
import { RigidContact } from '../../collision/narrow-phase/2d/rigid-contact';
import { BodyState, ROUND, flagsOf, poseOf } from '../../solver/2d/body';
import { contactOf } from '../../solver/2d/contact-place';
import { mayTurn, shareOfA } from '../../solver/2d/prepare-contacts';
import { RigidTable } from '../../solver/2d/rigid-table';
import { Impact, ImpactPoint, pointOf, setCoupling } from './impact';

// Moves levers by a part of what they miss. Where b is at X from a, the lever of an impulse P at a is longer than that at b by X × P.
export function moveToEnd(t: RigidTable, impact: Impact, part: real): void {
  const contact = contactOf(t, impact.place);
  if (!mayTurn(t, contact) || areDiscs(t, contact)) return;
  const shareA = shareOfA(t, contact);
  const a = changetype<BodyState>(impact.stateA);
  const b = changetype<BodyState>(impact.stateB);
  const x = poseOf(t, contact.bodyB).x - poseOf(t, contact.bodyA).x + (b.dx - a.dx);
  const y = poseOf(t, contact.bodyB).y - poseOf(t, contact.bodyA).y + (b.dy - a.dy);
  const normal = x * impact.ny - y * impact.nx;
  const tangent = -(x * impact.nx + y * impact.ny);
  for (let i = 0; i < impact.count; i++) {
    const point = pointOf(impact, i);
    moveNormal(impact, point, shareA, part * (normal - (point.leverA - point.leverB)));
    moveTangent(impact, point, shareA, part * (tangent - (point.tangentLeverA - point.tangentLeverB)));
  }
  setCoupling(impact);
}

function moveNormal(impact: Impact, point: ImpactPoint, shareA: real, missing: real): void {
  const before = turning(impact, point.leverA, point.leverB);
  point.leverA += shareA * missing;
  point.leverB -= (1 - shareA) * missing;
  point.ownMass = changed(point.ownMass, turning(impact, point.leverA, point.leverB) - before);
  point.mass = point.ownMass;
}

function moveTangent(impact: Impact, point: ImpactPoint, shareA: real, missing: real): void {
  const before = turning(impact, point.tangentLeverA, point.tangentLeverB);
  point.tangentLeverA += shareA * missing;
  point.tangentLeverB -= (1 - shareA) * missing;
  const after = turning(impact, point.tangentLeverA, point.tangentLeverB);
  point.tangentMass = changed(point.tangentMass, after - before);
}

// What an impulse at two levers gives the point by turning both bodies, 1/kg.
function turning(impact: Impact, leverA: real, leverB: real): real {
  return impact.inertiaA * leverA * leverA + impact.inertiaB * leverB * leverB;
}

// An effective mass whose inverse changes.
function changed(mass: real, change: real): real {
  return <real>1 / (<real>1 / mass + change);
}

// Whether both bodies, and not only parts of them, are discs.
function areDiscs(t: RigidTable, contact: RigidContact): bool {
  return (flagsOf(t, contact.bodyA) & flagsOf(t, contact.bodyB) & ROUND) != 0;
}
