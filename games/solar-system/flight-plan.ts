/** The burn that the player prepares: its predicted path, computed a little in every frame, and help with aiming. */
import type { BodyName } from '@principia/scenes';
import { AimSearch } from './aim.ts';
import { burnt, indexOf, rounded } from './flight.ts';
import type { Mission } from './missions.ts';
import { Prediction } from './prediction.ts';
import type { SolarGame } from './sim.ts';
import { DAY } from './solar-clock.ts';
import { TRACKED, Track } from './track.ts';

/** Days of the track and steps of probes that a frame of 1/60 s computes: about 3 ms. */
const TRACK_DAYS = 40;
const STEPS = 36;
/** Slow frames compute more, up to this factor. */
const MAX_LOAD = 8;
/** Seconds after which the path of a probe that flies is computed again. */
const REFRESH = 4;
/** How long a player may wait for the launch, days. */
export const MAX_WAIT = 60;

export type AimState = 'none' | 'running' | 'found' | 'failed';

export class FlightPlan {
  /** Forward, outward and north, km/s. */
  amounts: readonly number[] = [0, 0, 0];
  aimState: AimState = 'none';
  /** Counts finished paths. */
  version = 0;
  /** Closest approaches of the last finished path by index of `TRACKED`, km, and their dates, s since 2000. */
  readonly closest = new Float64Array(TRACKED.length).fill(Number.POSITIVE_INFINITY);
  readonly closestAt = new Float64Array(TRACKED.length);
  readonly track = new Track();
  readonly prediction = new Prediction(this.track);
  readonly #search = new AimSearch(this.track);
  #mission = '';
  #isStale = true;
  #sinceStart = 0;
  #load = 1;
  #burnCount = -1;

  get size(): number {
    return Math.hypot(...this.amounts);
  }

  set(amounts: readonly number[]): void {
    this.amounts = amounts.map(rounded);
    this.#isStale = true;
    this.aimState = 'none';
    this.#search.cancel();
  }

  /** Forgets the path, as where the world was replaced. */
  reset(): void {
    this.#mission = '';
    this.prediction.count = 0;
    this.prediction.isDone = true;
    this.closest.fill(Number.POSITIVE_INFINITY);
    this.#search.cancel();
    this.aimState = 'none';
    this.version++;
  }

  /** Whether help with aiming may be had: where the path passes the first planet closely enough, or the probe did. */
  canHelp({ flight }: SolarGame, { via, target, helpFrom }: Mission): boolean {
    const first = via ?? target;
    return Math.min(this.closest[TRACKED.indexOf(first)], flight.closest[indexOf(first)]) <= helpFrom;
  }

  /** Aims at a body. @param ahead how far before it, on its orbit, the probe shall pass, km; negative behind it */
  aim(game: SolarGame, target: BodyName, ahead: number, reach: number): void {
    const [now, end] = [game.clock.now, this.#endOf(game)];
    const index = TRACKED.indexOf(target);
    const { amounts } = this;
    this.#search.begin({
      probe: game.probeState(),
      sun: game.bodyState('sun'),
      amounts,
      now,
      end,
      target: index,
      ahead,
      reach,
    });
    this.aimState = 'running';
  }

  /** Called once a frame. @param seconds since the last one */
  update(game: SolarGame, seconds: number): void {
    this.#load = Math.max(1, Math.min(MAX_LOAD, 60 * seconds));
    this.#sinceStart += seconds;
    const { phase, mission, burns } = game.flight;
    if (game.clock.isTravelling || (phase !== 'ready' && phase !== 'flying')) {
      if (this.#mission !== '' && phase === 'none') this.reset();
      return;
    }
    if (this.#mission !== mission || game.clock.now < this.track.start) this.#begin(game);
    if (burns.length !== this.#burnCount) this.#isStale = true;
    this.#burnCount = burns.length;
    const isComplete = this.track.extend(
      game.flight.start + ((game.mission?.maxDays ?? 0) + MAX_WAIT) * DAY,
      TRACK_DAYS * this.#load,
    );
    if (this.aimState === 'running') {
      if (isComplete) this.#aimOn();
      return;
    }
    if (phase === 'flying' && this.prediction.isDone && this.#sinceStart > REFRESH) this.#isStale = true;
    if (this.prediction.isDone && this.#isStale) this.#predict(game);
    if (!this.prediction.isDone && this.prediction.advance(this.#load * STEPS)) {
      this.closest.set(this.prediction.closest);
      this.closestAt.set(this.prediction.closestAt);
      this.version++;
    }
  }

  destroy(): void {
    this.track.destroy();
    this.prediction.destroy();
    this.#search.destroy();
  }

  #begin(game: SolarGame): void {
    const { aim = [0, 0, 0] } = game.mission ?? {};
    this.#mission = game.flight.mission;
    this.#burnCount = game.flight.burns.length;
    this.set(game.flight.phase === 'ready' ? aim : [0, 0, 0]);
    this.prediction.isDone = true;
    this.closest.fill(Number.POSITIVE_INFINITY);
    this.track.begin(game);
  }

  #aimOn(): void {
    if (!this.#search.advance(2 * this.#load * STEPS)) return;
    const { amounts, miss } = this.#search;
    const isFound = miss < Number.POSITIVE_INFINITY && this.#search.isReached;
    this.set(amounts);
    this.aimState = isFound ? 'found' : 'failed';
  }

  #predict(game: SolarGame): void {
    this.#isStale = false;
    this.#sinceStart = 0;
    const probe = game.probeState();
    const [forward, outward, north] = this.amounts;
    const velocity = burnt(probe, game.bodyState('sun'), [0, forward, outward, north]);
    this.prediction.start(probe.position, [velocity], game.clock.now, this.#endOf(game));
  }

  /** The end of the flight if it is launched now. */
  #endOf(game: SolarGame): number {
    const { phase, launch } = game.flight;
    return (phase === 'flying' ? launch : game.clock.now) + (game.mission?.maxDays ?? 0) * DAY;
  }
}
