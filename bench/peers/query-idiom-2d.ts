// The four systems of the query idiom in 2D.
import { query } from 'bitecs';
import { rebound } from './particles-columns.ts';
import type { QueryState } from './query-idiom.ts';

export function systems2d(state: QueryState): (() => void)[] {
  return [() => fall(state), () => brake(state), () => move(state), () => bounce(state)];
}

function fall({ world, gravity, Force, Mass }: QueryState): void {
  for (const eid of query(world, [Force, Mass])) {
    Force.x[eid] = 0;
    Force.y[eid] = -gravity * (Mass[eid] as number);
  }
}

function brake({ world, Velocity, Force, Drag }: QueryState): void {
  for (const eid of query(world, [Force, Velocity, Drag])) {
    const x = Velocity.x[eid] as number;
    const y = Velocity.y[eid] as number;
    const k = (Drag[eid] as number) * Math.sqrt(x * x + y * y);
    Force.x[eid] = (Force.x[eid] as number) - k * x;
    Force.y[eid] = (Force.y[eid] as number) - k * y;
  }
}

function move({ world, dt, Position, Velocity, Start, Force, Mass }: QueryState): void {
  for (const eid of query(world, [Position, Velocity, Force, Mass])) {
    const m = Mass[eid] as number;
    Start.x[eid] = Velocity.x[eid] as number;
    Start.y[eid] = Velocity.y[eid] as number;
    Velocity.x[eid] = (Velocity.x[eid] as number) + ((Force.x[eid] as number) / m) * dt;
    Velocity.y[eid] = (Velocity.y[eid] as number) + ((Force.y[eid] as number) / m) * dt;
    Position.x[eid] = (Position.x[eid] as number) + (Velocity.x[eid] as number) * dt;
    Position.y[eid] = (Position.y[eid] as number) + (Velocity.y[eid] as number) * dt;
  }
}

function bounce({ world, dt, side, wall, Position, Velocity, Start, Radius }: QueryState): void {
  for (const eid of query(world, [Position, Velocity, Radius])) {
    const low = Radius[eid] as number;
    const high = side - low;
    const x = Position.x[eid] as number;
    const y = Position.y[eid] as number;
    if (x < low) rebound(Position.x, Velocity.x, eid, Start.x[eid] as number, low, 1, wall, dt);
    else if (x > high) rebound(Position.x, Velocity.x, eid, Start.x[eid] as number, high, -1, wall, dt);
    if (y < low) rebound(Position.y, Velocity.y, eid, Start.y[eid] as number, low, 1, wall, dt);
    else if (y > high) rebound(Position.y, Velocity.y, eid, Start.y[eid] as number, high, -1, wall, dt);
  }
}
