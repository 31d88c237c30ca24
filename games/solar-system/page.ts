/** What the page remembers beyond a single world: where the player begins, and which body is followed. */
import type { BodyName } from '@principia/scenes';
import { flightLink, type Link, readLink } from './link.ts';
import type { Mission } from './missions.ts';
import type { FollowName } from './picture.ts';
import type { Opening, SolarGame } from './sim.ts';

export class Page {
  opening: Opening;
  follow: FollowName;
  /** What the address says that cannot be read. */
  problems: readonly string[];

  constructor(hash: string) {
    const link: Link = readLink(hash);
    this.opening = link;
    this.follow = link.follow;
    this.problems = link.problems;
  }

  /** The next world begins on the date of this one. */
  keepDate(sim: SolarGame): void {
    const { clock, flight } = sim;
    const date = clock.isTravelling ? this.opening.date : clock.julianDate;
    this.opening = { date, rate: clock.rate, mission: flight.mission, burns: [] };
  }

  goTo(sim: SolarGame, date: number): void {
    this.opening = { ...this.opening, date, mission: '', burns: [] };
    writeHash('');
    sim.travelTo(date);
  }

  startMission(sim: SolarGame, mission: Mission): void {
    this.opening = { ...this.opening, mission: mission.id, burns: [] };
    this.follow = 'sun';
    writeHash(`#mission=${mission.id}`);
    sim.startMission(mission);
  }

  endMission(sim: SolarGame): void {
    this.opening = { ...this.opening, date: sim.clock.julianDate, mission: '', burns: [] };
    writeHash('');
    sim.endFlight();
    if (this.follow === 'probe') this.follow = 'sun';
  }

  /** Puts the flight so far into the address, for the link that is shared. */
  rememberFlight({ flight }: SolarGame): void {
    writeHash(flightLink(flight.mission, flight.burns));
  }

  /** Follows a body by its number on the keyboard. */
  followNumber(names: readonly BodyName[], index: number): void {
    const name = names[index];
    if (name !== undefined) this.follow = name;
  }
}

function writeHash(hash: string): void {
  history.replaceState(null, '', `${location.pathname}${location.search}${hash}`);
}
