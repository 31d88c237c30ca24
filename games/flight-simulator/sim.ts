/** The simulation: one aeroplane, its ground, its wind and its mission. It needs no display. */
import { columnsOf, cos, createPhysicsWorld, keepState, type PhysicsWorld, sin, spawn } from '@principia/physics';
import { addComponent, set } from 'bitecs';
import { AIRCRAFT, Deflections, Flow, propellerThrust } from './aircraft.ts';
import { Airflow } from './airflow.ts';
import { engage } from './altitude-hold.ts';
import { type Attitude, createAttitude, readAttitude } from './attitude.ts';
import type { Axes } from './body-frame.ts';
import { MISSIONS, type Mission, RESTING_HEIGHT, startOf } from './course.ts';
import { DrydenGusts } from './dryden-gusts.ts';
import { type GearState, landingGear } from './landing-gear.ts';
import { createPilotState, type Inputs, movePilot, type PilotState, type Surfaces } from './pilot.ts';
import { createLog, type FlightLog, judge } from './referee.ts';
import { groundHeight } from './terrain.ts';
import { aircraftForces } from './wing-laws.ts';

/** The settings of a flight. */
export interface FlightValues {
  readonly mission: string;
  readonly assist: boolean;
  readonly inverted: boolean;
  readonly crosswind: number;
  /** Deviation of the vertical gusts, m/s. */
  readonly turbulence: number;
  /** Whether separation of the flow lags behind the angle of attack; default yes. */
  readonly unsteady?: boolean;
  /** Whether the tail feels the propeller; default yes. */
  readonly propwash?: boolean;
  /** Whether the autopilot holds the altitude; default no. */
  readonly altitudeHold?: boolean;
}

export interface FlightOptions {
  readonly values: FlightValues;
  readonly seed: number;
}

const DT = 1 / 240;

/** Angle of attack at which the stall warning sounds, rad. */
const WARNING_ATTACK = 0.24;

/** One flight. */
export class Flight {
  readonly dt = DT;
  readonly world: PhysicsWorld;
  readonly plane: number;
  readonly mission: Mission;
  readonly log: FlightLog;
  readonly pilot: PilotState;
  /** Attitude after the last step. */
  readonly attitude: Attitude = createAttitude();
  readonly inputs: Inputs = { roll: 0, pull: 0, rudder: 0, throttle: 0, brake: 0 };
  readonly #held = new Set<string>();
  readonly #ground = { onGround: true, height: 0, altitude: 0, climb: 0 };
  readonly #gear: GearState = { brake: 0, rudder: 0 };
  readonly #surfaces: Surfaces = { aileron: 0, elevator: 0, rudder: 0 };
  readonly #air: Airflow;
  readonly #gusts: DrydenGusts;
  readonly #flow = { isUnsteady: true, hasWash: true };
  #values: FlightValues;
  #stickX = 0;
  #stickY = 0;
  #pedals = 0;
  #isBraking = false;

  constructor({ values, seed }: FlightOptions) {
    this.#values = values;
    this.mission = MISSIONS.find((name) => name === values.mission) ?? 'circuit';
    this.#gusts = new DrydenGusts({ x: 0, y: 0, z: values.crosswind }, values.turbulence, seed);
    this.world = createPhysicsWorld({
      dimensions: 3,
      capacity: 4,
      seed,
      components: [Deflections, Flow],
      forces: aircraftForces((time) => this.#gusts.at(time)),
    });
    const { at, speed, throttle } = startOf(this.mission);
    this.plane = spawn(this.world, {
      position: at,
      velocity: { x: speed },
      mass: AIRCRAFT.mass,
      inertiaTensor: AIRCRAFT.inertiaTensor,
      orientation: {},
      angularVelocity: {},
      thrust: {},
      quadraticDrag: AIRCRAFT.parasite,
    });
    addComponent(this.world, this.plane, set(columnsOf(this.world, Deflections), { ...this.#surfaces }));
    addComponent(this.world, this.plane, set(columnsOf(this.world, Flow), {}));
    this.#air = new Airflow(this.world, this.plane);
    this.#gusts.keep(this.world);
    this.world.forces.push(landingGear(this.plane, this.#gear));
    this.pilot = createPilotState(throttle);
    this.log = createLog(this.mission, at);
    keepState(this.world, this.log, this.pilot, this.pilot.hold, this.#gear, this.attitude);
    this.#look();
    this.world.phases.input.push((_, dt) => this.#steer(dt));
    this.world.phases.events.push(() => {
      this.#look();
      judge(this.world, this.plane, this.log, this.attitude, this.mission);
    });
  }

  /** Height of the centre of mass above the ground, m. */
  get height(): number {
    const { x, y, z } = this.world.components.Position;
    return y[this.plane] - groundHeight(x[this.plane], z[this.plane]);
  }

  /** Height of the wheels above the airfield, m: what an altimeter shows. */
  get altitude(): number {
    return this.world.components.Position.y[this.plane] - RESTING_HEIGHT;
  }

  /** Climb, m/s. */
  get climb(): number {
    return this.world.components.Velocity.y[this.plane];
  }

  /** Whether the wing is about to stall, or has. */
  get isStalling(): boolean {
    return this.attitude.attack > WARNING_ATTACK && !this.log.onGround;
  }

  /** Velocity of the air, m/s. */
  get wind(): Readonly<Axes> {
    return this.#gusts.at(this.world.time);
  }

  set(values: FlightValues): void {
    this.#values = values;
  }

  /** A button was pressed or released. */
  press(name: string, isDown: boolean): void {
    if (isDown) this.#held.add(name);
    else this.#held.delete(name);
  }

  /** The stick, on the screen or of a gamepad: y up is forwards, which lowers the nose. */
  stick(x: number, y: number): void {
    this.#stickX = x;
    this.#stickY = y;
  }

  /** The pedals of the rudder: from −1, left, to 1. */
  pedals(position: number): void {
    this.#pedals = position;
  }

  /** Where the pedals are, without what keys add. */
  get pedalPosition(): number {
    return this.#pedals;
  }

  /** Moves the throttle by a fraction. A lever pulled below idle brakes until it is pushed again. */
  moveLever(change: number): void {
    const { pilot } = this;
    this.#isBraking = change < 0 && pilot.throttle === 0;
    pilot.throttle = Math.min(1, Math.max(0, pilot.throttle + change));
  }

  /** Reads buttons and stick, and moves the controls. */
  #steer(dt: number): void {
    const held = (name: string) => Number(this.#held.has(name));
    const { inputs } = this;
    inputs.roll = clampUnit(this.#stickX + held('right') - held('left'));
    inputs.pull = clampUnit(held('down') - held('up') - this.#stickY) * (this.#values.inverted ? -1 : 1);
    inputs.rudder = clampUnit(this.#pedals + held('rudderRight') - held('rudderLeft'));
    inputs.throttle = held('more') - held('less');
    inputs.brake = Math.max(held('brake'), Number(this.#isBraking));
    const { world, plane, pilot, attitude, log } = this;
    this.#ground.onGround = log.onGround;
    this.#ground.height = this.height;
    this.#ground.altitude = this.altitude;
    this.#ground.climb = this.climb;
    this.#switchHold();
    movePilot(pilot, inputs, attitude, this.#values.assist, this.#ground, dt, this.#surfaces);
    const columns = columnsOf(world, Deflections);
    columns.aileron[plane] = this.#surfaces.aileron;
    columns.elevator[plane] = this.#surfaces.elevator;
    columns.rudder[plane] = this.#surfaces.rudder;
    this.#gear.brake = pilot.brake;
    this.#gear.rudder = this.#surfaces.rudder;
    const push = propellerThrust(pilot.throttle, attitude.airspeed);
    world.components.Thrust.x[plane] = push;
    this.#blow(push, dt);
  }

  /** Moves the gusts, and the flow about the aeroplane. */
  #blow(push: number, dt: number): void {
    const { unsteady = true, propwash = true, turbulence } = this.#values;
    if (turbulence > 0) {
      // From the north, which is −z, clockwise.
      const { heading, airspeed } = this.attitude;
      this.#gusts.step(this.world.time, dt, this.height, airspeed, sin(heading), -cos(heading));
    }
    this.#flow.isUnsteady = unsteady;
    this.#flow.hasWash = propwash;
    this.#air.update(this.wind, turbulence > 0 ? this.#gusts.roll : 0, push, this.#flow, dt);
  }

  /** The autopilot begins with the altitude at which it is switched on, and not before the aeroplane flies. */
  #switchHold(): void {
    const { pilot, attitude, log } = this;
    const isWanted = this.#values.altitudeHold === true && !log.onGround;
    if (isWanted && !pilot.hold.isOn) engage(pilot.hold, this.altitude, attitude.pitch, this.climb);
    if (pilot.hold.isOn && !isWanted) {
      pilot.hold.isOn = false;
      pilot.targetPitch = attitude.pitch;
    }
  }

  #look(): void {
    readAttitude(this.world, this.plane, this.wind, this.attitude);
  }
}

const clampUnit = (value: number) => Math.min(1, Math.max(-1, value));

export function createFlight(options: FlightOptions): Flight {
  return new Flight(options);
}

/** Applies a changed setting to the running flight; false if the setting requires a new one. */
export function applyValue(flight: Flight, name: string, values: FlightValues): boolean {
  flight.set(values);
  return name !== 'mission' && name !== 'crosswind' && name !== 'turbulence';
}
