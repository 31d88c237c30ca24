/** The simulation: Sun, planets, Moon and Pluto from JPL's states, and a probe. It needs no display. */
import { despawn, keepState, spawn } from '@principia/physics';
import {
  BODY_NAMES,
  type BodyName,
  buildSolarSystem,
  type Checkpoint,
  checkpoints,
  EPOCH,
  EPOCH_2012,
  type SolarEpoch,
  type SolarSystem,
  solarState,
} from '@principia/scenes';
import {
  type Burn,
  burnt,
  closestIn,
  encounterInterval,
  type Flight,
  indexOf,
  newFlight,
  RADII,
  rounded,
  type State,
  waitingState,
} from './flight.ts';
import { type Mission, missionOf } from './missions.ts';
import { DAY, SolarClock, YEAR } from './solar-clock.ts';
import { timeLapse } from './time-lapse.ts';
import { difference, type Vector, vector } from './vectors.ts';

/** What a game begins with. */
export interface Opening {
  /** Julian date. */
  readonly date: number;
  readonly rate: number;
  /** Id of a mission, and the burns of a flight to watch. */
  readonly mission: string;
  readonly burns: readonly Burn[];
}

export interface SolarValues {
  readonly moon: boolean;
}

export interface SolarOptions {
  readonly values: SolarValues;
  readonly opening: Opening;
}

/** Dates that a journey may have as its end: beyond, tides and asteroids would matter more than what is computed here. */
export const DATES = { first: 2415020.5, last: 2488069.5 } as const;

/** A journey starts from the present state if it is shorter than this, s. */
const NEAR = 3 * YEAR;

/** km³/s²: a probe of a ton attracts nothing. */
const PROBE_GM = 1e-16;

const secondsOf = (date: number) => (date - EPOCH) * DAY;

export class SolarGame {
  readonly system: SolarSystem;
  readonly clock: SolarClock;
  /** Length of a step, s of the player's time. */
  readonly dt = 1 / 60;
  readonly flight: Flight = newFlight();
  /** Distance from JPL's positions at the last date for which these are stored, km, and that date; by body. */
  readonly errors = new Float64Array(BODY_NAMES.length).fill(Number.NaN);
  readonly errorDates = new Float64Array(BODY_NAMES.length);
  readonly opening: Opening;
  /** A flight that is repeated from its burns. */
  isReplay = false;
  /** Missions that began in this world. It is no state of it: who goes back to one before goes on with the attempt. */
  missionsBegun = 0;
  readonly #hasMoon: boolean;
  readonly #checkpoints: readonly Checkpoint[] = checkpoints();
  /** Burns of a replay that are still to come, and how many were made. */
  #script: readonly Burn[] = [];
  readonly #scripted = new Float64Array(1);

  constructor({ values, opening }: SolarOptions) {
    this.opening = opening;
    this.#hasMoon = values.moon;
    this.clock = new SolarClock({
      hasMoon: values.moon,
      stands: () => this.flight.phase !== 'none' && this.flight.phase !== 'flying' && !this.hasScript,
      hasProbe: () => this.flight.probe !== 0,
      encounterLimit: () => this.#encounterLimit(),
      nextStop: (now, direction) => this.#nextStop(now, direction),
      reached: (now, interval) => this.#reached(now, interval),
      arrived: (direction) => this.#arrived(direction),
    });
    this.system = buildSolarSystem({ moon: values.moon, others: 1, integrator: timeLapse(this.clock) });
    keepState(this.world, this.clock.state, this.flight, this.errors, this.errorDates, this.#scripted);
    this.clock.rate = opening.rate;
    const mission = missionOf(opening.mission);
    if (mission === undefined) this.travelTo(opening.date);
    else this.startMission(mission, opening.burns);
  }

  get world() {
    return this.system.world;
  }

  get mission(): Mission | undefined {
    return missionOf(this.flight.mission);
  }

  /** Position and velocity of a body of this world. */
  stateOf(id: number): State {
    const { Position, Velocity } = this.world.components;
    return {
      position: vector(Position.x[id], Position.y[id], Position.z[id]),
      velocity: vector(Velocity.x[id], Velocity.y[id], Velocity.z[id]),
    };
  }

  /** The state of a body by name. Without the Moon, the Earth is the centre of mass of both. */
  bodyState(name: BodyName): State {
    return this.stateOf(this.system.ids[name] as number);
  }

  /** The state of the probe; before the launch it waits beyond the Earth. */
  probeState(): State {
    const { probe } = this.flight;
    return probe === 0 ? waitingState(this.bodyState('sun'), this.bodyState('earth')) : this.stateOf(probe);
  }

  /** Moves all bodies to another date, from the present one or from the nearest of JPL's states. */
  travelTo(date: number): void {
    this.endFlight();
    const wanted = secondsOf(Math.min(DATES.last, Math.max(DATES.first, date)));
    const { now } = this.clock;
    const isKnown = this.world.tick > 0 && !this.clock.isTravelling;
    if (isKnown && wanted >= now && wanted - now < NEAR) {
      this.clock.travel(now, wanted);
      return;
    }
    const second = secondsOf(EPOCH_2012);
    const epoch = Math.abs(wanted - second) < Math.abs(wanted) ? 2012 : 2000;
    const from = epoch === 2012 ? second : 0;
    this.#load(epoch, wanted < from ? -1 : 1);
    this.errors.fill(Number.NaN);
    this.clock.travel(from, wanted);
    // The state itself is that of a date with stored positions.
    this.#compare(from);
  }

  /** Goes to the start of a mission, where a probe waits. @param burns of a flight to repeat */
  startMission(mission: Mission, burns: readonly Burn[] = []): void {
    this.missionsBegun++;
    this.travelTo(mission.start);
    const { flight } = this;
    Object.assign(flight, newFlight(), { phase: 'ready', mission: mission.id, start: secondsOf(mission.start) });
    this.#script = burns;
    this.#scripted[0] = 0;
    this.isReplay = burns.length > 0;
  }

  /** Ends mission and flight, and keeps the date. */
  endFlight(): void {
    if (this.flight.probe !== 0) despawn(this.world, this.flight.probe);
    Object.assign(this.flight, newFlight());
    this.#script = [];
    this.isReplay = false;
  }

  /** The same flight from its beginning, as a replay. */
  again(): SolarGame {
    const { mission, burns } = this.flight;
    const opening = { ...this.opening, mission, burns: [...burns] };
    return new SolarGame({ values: { moon: this.#hasMoon }, opening });
  }

  /** Whether a change of velocity of this size, km/s, is within what the mission allows. */
  canBurn(size: number): boolean {
    const { phase, deltaV } = this.flight;
    const budget = this.mission?.budget ?? 0;
    return (phase === 'ready' || phase === 'flying') && size > 0 && deltaV + size <= budget + 1e-9;
  }

  /** Changes the velocity of the probe, which launches it, km/s. @returns whether the mission allows it */
  burn(forward: number, outward: number, north: number): boolean {
    if (this.clock.isTravelling) return false;
    const amounts = [forward, outward, north].map(rounded);
    const size = Math.sqrt(amounts.reduce((total, amount) => total + amount * amount, 0));
    if (!this.canBurn(size)) return false;
    const { flight, clock } = this;
    const made: Burn = [clock.now - flight.start, amounts[0], amounts[1], amounts[2]];
    const before = this.probeState();
    const velocity = burnt(before, this.bodyState('sun'), made);
    if (flight.probe === 0) this.#launch(before.position, velocity);
    else {
      const { Velocity } = this.world.components;
      Velocity.x[flight.probe] = velocity.x;
      Velocity.y[flight.probe] = velocity.y;
      Velocity.z[flight.probe] = velocity.z;
    }
    flight.deltaV += size;
    flight.burns = [...flight.burns, made];
    return true;
  }

  /** Lets a probe that is ready wait beyond the Earth. */
  wait(days: number): void {
    const { clock, flight } = this;
    if (flight.phase === 'ready' && !clock.isTravelling) clock.travel(clock.now, clock.now + days * DAY);
  }

  #launch(position: Vector, velocity: Vector): void {
    const { flight } = this;
    flight.probe = spawn(this.world, { position, velocity, mass: PROBE_GM, testParticle: {} });
    flight.phase = 'flying';
    flight.launch = this.clock.now;
  }

  /** Days since the launch; of a flight that ended, until then. */
  flightDays(): number {
    const { phase, launch, end } = this.flight;
    if (phase === 'none' || phase === 'ready') return 0;
    return ((phase === 'flying' ? this.clock.now : end) - launch) / DAY;
  }

  #load(epoch: SolarEpoch, direction: number): void {
    const { Position, Velocity } = this.world.components;
    for (const name of BODY_NAMES) {
      const id = this.system.ids[name];
      if (id === undefined) continue;
      const { position, velocity } = solarState(name, epoch, this.#hasMoon);
      for (const axis of ['x', 'y', 'z'] as const) {
        Position[axis][id] = position[axis];
        // Gravity, also its relativistic term, runs backwards as it runs forwards.
        Velocity[axis][id] = direction * velocity[axis];
      }
    }
    this.world.versions.pose++;
  }

  #arrived(direction: number): void {
    if (direction > 0) return;
    const { x, y, z } = this.world.components.Velocity;
    for (const id of Object.values(this.system.ids)) for (const column of [x, y, z]) column[id] = -column[id];
  }

  /** The next date with stored positions, or of the next burn of a replay. */
  #nextStop(now: number, direction: number): number {
    let stop = direction * Number.POSITIVE_INFINITY;
    for (let i = 0; i < this.#checkpoints.length; i++) {
      const date = secondsOf(this.#checkpoints[i].julianDate);
      if (direction > 0 ? date > now && date < stop : date < now && date > stop) stop = date;
    }
    const next = this.#script[this.#scripted[0]];
    const burn = next === undefined ? Number.NaN : this.flight.start + next[0];
    return direction > 0 && burn > now && burn < stop ? burn : stop;
  }

  #reached(now: number, interval: number): void {
    if (!this.clock.usesMap) this.#compare(now);
    if (this.flight.phase === 'flying') this.#follow(now, interval);
    this.#runScript();
  }

  /** Whether burns of a replay are still to come. */
  get hasScript(): boolean {
    return this.#scripted[0] < this.#script.length;
  }

  /** Makes the burns of a replay that are due. */
  #runScript(): void {
    const { flight, clock } = this;
    for (;;) {
      const next = this.#script[this.#scripted[0]];
      if (next === undefined || clock.isTravelling || clock.now < flight.start + next[0] - 1e-3) return;
      this.#scripted[0]++;
      const [, forward, outward, north] = next;
      if (!this.burn(forward, outward, north)) return;
    }
  }

  /** Measures the distance from JPL's positions, on a date that has them. */
  #compare(now: number): void {
    for (let i = 0; i < this.#checkpoints.length; i++) {
      if (Math.abs(secondsOf(this.#checkpoints[i].julianDate) - now) > 1e-3) continue;
      for (const [name, error] of Object.entries(this.#checkpoints[i].errors(this.system))) {
        this.errors[indexOf(name as BodyName)] = error;
        this.errorDates[indexOf(name as BodyName)] = this.#checkpoints[i].julianDate;
      }
    }
  }

  #encounterLimit(): number {
    const probe = this.stateOf(this.flight.probe);
    let limit = Number.POSITIVE_INFINITY;
    for (const name of BODY_NAMES) {
      if (this.system.ids[name] === undefined) continue;
      const { position, velocity } = this.bodyState(name);
      limit = Math.min(
        limit,
        encounterInterval(difference(probe.position, position), difference(probe.velocity, velocity)),
      );
    }
    return limit;
  }

  /** Updates the closest approaches, and ends the flight where it arrived, hit something or took too long. */
  #follow(now: number, interval: number): void {
    const { flight } = this;
    const mission = this.mission as Mission;
    const probe = this.stateOf(flight.probe);
    for (const [i, name] of BODY_NAMES.entries()) {
      if (this.system.ids[name] === undefined) continue;
      const { position, velocity } = this.bodyState(name);
      const separation = difference(probe.position, position);
      const { distance, ago } = closestIn(separation, difference(probe.velocity, velocity), interval);
      if (distance < flight.closest[i]) {
        flight.closest[i] = distance;
        flight.closestAt[i] = now - ago;
      }
      if (distance < RADII[i]) flight.hit = i;
    }
    if (flight.closest[indexOf(mission.target)] <= mission.reach) this.#end('arrived', now);
    else if (flight.hit >= 0) this.#end('crashed', now);
    else if (this.flightDays() > mission.maxDays) this.#end('lost', now);
  }

  #end(phase: Flight['phase'], now: number): void {
    this.flight.phase = phase;
    this.flight.end = now;
    this.clock.stopStep();
    if (phase !== 'crashed') return;
    despawn(this.world, this.flight.probe);
    this.flight.probe = 0;
  }
}

export function createGame(options: SolarOptions): SolarGame {
  return new SolarGame(options);
}
