/** The sounds: a launch, a burn, an arrival, a loss. */
import { Synth } from '@principia/shell';
import type { Phase } from './flight.ts';
import type { SolarGame } from './sim.ts';

export interface Sounds {
  update(sim: SolarGame, isOn: boolean): void;
  destroy(): void;
}

export function createSounds(): Sounds {
  const synth = new Synth();
  let phase: Phase = 'none';
  let burns = 0;
  return {
    update({ flight }, isOn) {
      synth.set(isOn);
      if (flight.burns.length > burns) synth.noise({ frequency: 180, to: 60, loudness: 0.5, seconds: 1.4 });
      if (flight.phase !== phase && flight.phase === 'arrived') {
        for (const [i, frequency] of [523, 659, 784].entries()) {
          synth.tone({ frequency, loudness: 0.22, seconds: 0.7 + 0.3 * i });
        }
      }
      if (flight.phase !== phase && (flight.phase === 'lost' || flight.phase === 'crashed')) {
        synth.tone({ frequency: 180, to: 70, loudness: 0.3, seconds: 0.9 });
      }
      phase = flight.phase;
      burns = flight.burns.length;
    },
    destroy: () => synth.destroy(),
  };
}
