import {
  PHASES,
  type PhysicsWorld,
  type Profile,
  resetProfile,
  SOLVER_STAGES,
  startProfile,
  stopProfile,
} from '@principia/physics';
import { element } from './element.ts';
import { decimal } from './language.ts';
import { words } from './words.ts';

/** The time of a step, phase by phase, and of rigid bodies stage by stage. */
export interface ProfileCard {
  /** Shows the mean milliseconds per step since the last call. */
  show(world: PhysicsWorld): void;
  toggle(): void;
}

export function createProfileCard(parent: HTMLElement): ProfileCard {
  const phases = createBars(PHASES);
  const stages = createBars(SOLVER_STAGES);
  const title = element('h2', '', {}, words().profileTitle);
  const stagesTitle = element('h2', '', {}, words().profileStages);
  const card = element('section', 'game-card', { 'aria-label': words().profile });
  card.append(title, phases.list, stagesTitle, stages.list);
  card.hidden = true;
  parent.append(card);
  let watched: { readonly world: PhysicsWorld; readonly profile: Profile; tick: number } | undefined;
  const watch = (world: PhysicsWorld) => ({
    world,
    profile: startProfile(world, () => performance.now()),
    tick: world.tick,
  });
  const update = (world: PhysicsWorld) => {
    if (watched?.world !== world) watched = watch(world);
    const { profile, tick } = watched;
    const steps = world.tick - tick;
    watched.tick = world.tick;
    if (steps > 0) {
      phases.show(profile.times, steps);
      const total = stages.show(profile.stages, steps);
      // Worlds without rigid bodies have no such stages.
      stagesTitle.hidden = stages.list.hidden = total === 0;
    }
    resetProfile(profile);
  };
  return {
    show(world) {
      if (!card.hidden) update(world);
    },
    toggle() {
      card.hidden = !card.hidden;
      if (!card.hidden || watched === undefined) return;
      // Reading the clock costs time, so a hidden card measures nothing.
      if (watched.world.state !== 'destroyed') stopProfile(watched.world);
      watched = undefined;
    },
  };
}

/** A list of times with a bar for each. */
function createBars<Name extends string>(names: readonly Name[]) {
  const list = element('dl', 'game-profile');
  const rows = names.map((name) => {
    const bar = element('i', '');
    const time = element('dd', '', {}, '–');
    list.append(element('dt', '', {}, words().names[name] ?? name), bar, time);
    return { name, bar, time };
  });
  return {
    list,
    /** Shows the means of sums over some steps, ms, and returns the sum of all. */
    show(times: Readonly<Record<Name, number>>, steps: number): number {
      const total = names.reduce((sum, name) => sum + times[name], 0);
      for (const { name, bar, time } of rows) {
        const mean = times[name] / steps;
        bar.style.setProperty('--share', String(total > 0 ? times[name] / total : 0));
        time.textContent = `${decimal(mean, mean < 1 ? 3 : 1)} ms`;
      }
      return total;
    },
  };
}
