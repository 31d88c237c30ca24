// Where two shapes touch in the middle of the step, if one of them slides or rolls over the other and the normal turns as it
// goes: a disc over what does not move by forces, and any shape over a chain. With the normal of the start of the step, which
// lags by half a step, the force N has a part along the way,
//
//   N v dt / 2R
//
// so that a ball in a bowl gained g dt / 2R of its speed in a second, and one on a ball lost it. The normal of the middle leaves
// an error of second order.
//
// Two discs that press each other as they go round lost angular momentum for the same reason. Their impulses act at the beginnings
// of the sub-steps, of which (dt - h)/2 is the mean.
import { DYNAMIC, FAST, MOVES, flagsOf, poseOf, word } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { CIRCLE, Shape } from '../../shapes/2d/shape';
import { motionOf } from './collide-ahead';
import { Manifold } from './manifold';
import { RigidContact } from './rigid-contact';
import { velocityX, velocityY } from './shape-velocity';

// A shape goes on by this part of its least extent at most, so that its centre stays on its side of the surface.
const MOST: real = 0.5;

// Moves the shapes to where they will be. What touched nothing in the last step flies, and stays.
export function moveToMiddle(t: RigidTable, contact: RigidContact, m: Manifold, shapeA: Shape, shapeB: Shape): void {
  const flagsA = flagsOf(t, contact.a);
  const flagsB = flagsOf(t, contact.b);
  if (((flagsA | flagsB) & FAST) != 0) return;
  const bothMove = (flagsA & flagsB & DYNAMIC) != 0;
  if (bothMove) {
    if (shapeA.kind != CIRCLE || shapeB.kind != CIRCLE) return;
  } else {
    const isRound = ((flagsA & DYNAMIC) != 0 ? shapeA : shapeB).kind == CIRCLE;
    if (!isRound && (shapeA.isChained | shapeB.isChained) == 0) return;
  }
  pathX = 0;
  pathY = 0;
  const time = <real>(0.5 * (bothMove ? t.dt - t.h : t.dt));
  addPath(t, contact.bodyB, contact.b, time);
  addPath(t, contact.bodyA, contact.a, -time);
  const path = sqrt<real>(pathX * pathX + pathY * pathY);
  const limit = MOST * min<real>(extentOf(t, contact.a), extentOf(t, contact.b));
  const part = path > limit ? limit / path : <real>1;
  m.bx += part * pathX;
  m.by += part * pathY;
}

// The least extent of what forces move.
// @ts-ignore: decorator
@inline function extentOf(t: RigidTable, row: i32): real {
  return (flagsOf(t, row) & DYNAMIC) != 0 ? poseOf(t, row).minExtent : <real>Infinity;
}

let pathX: real = 0;
let pathY: real = 0;

// Adds the path of the centre of a shape within a time, which is negative for the path back.
function addPath(t: RigidTable, body: i32, row: i32, time: real): void {
  const flags = flagsOf(t, body);
  // Colors are of what contacts push.
  if ((flags & MOVES) == 0 || ((flags & DYNAMIC) != 0 && word(t.usedColors, body) == 0)) return;
  const state = motionOf(t, body);
  pathX += time * velocityX(t, state, body, row);
  pathY += time * velocityY(t, state, body, row);
}
