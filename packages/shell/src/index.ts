/** The parts that all games share: loop, settings panel, plot, keyboard, help and error messages. */
export { type Address, FIRST_PLOT, readAddress } from './address.ts';
export { bytesOfText, packText, textOfBytes, unpackText } from './address-text.ts';
export { chooseWords } from './choose-words.ts';
export { type ClipButton, type ClipControl, createClipButton } from './clip-button.ts';
export { hasCoarsePointer } from './coarse-pointer.ts';
export { type ControlButton, type ControlListener, type Controls, FOUR_WAYS, listenToControls } from './controls.ts';
export { copyLink } from './copy-link.ts';
export { csvOf, saveText } from './csv.ts';
export { type Dragging, type DragOptions, dragBodies } from './dragging.ts';
export { element } from './element.ts';
export type {
  GameCard,
  GameDefinition,
  GameQuantity,
  HelpLine,
  Insets,
  Renderer,
  Simulation,
  SimulationOptions,
  View,
  ViewContext,
} from './game.ts';
export { helpLines } from './help-lines.ts';
export { type HighScore, HighScores } from './high-scores.ts';
export { showHint } from './hint.ts';
export { dragByJoints } from './joint-dragging.ts';
export { KeptValue } from './kept-value.ts';
export { listenToKeys } from './keyboard.ts';
export { decimal, grouped, inLanguage, type Language, language, withLanguage } from './language.ts';
export { dayOf } from './local-day.ts';
export { browserStore, type LocalStore, readLocal, writeLocal } from './local-store.ts';
export { speakNumbers } from './number-field.ts';
export type { Outcome } from './outcome-card.ts';
export { followPastedLinks } from './pasted-links.ts';
export { drawDot, drawPath, drawTimeMark } from './path-plot.ts';
export { pickBody2D } from './pick.ts';
export { type AppearanceOptions, SAFE_COLORS } from './preferences.ts';
export { rangeAbout } from './range-about.ts';
export { Session } from './session.ts';
export {
  type ChoiceSetting,
  checkValue,
  initialValues,
  type NumberSetting,
  numberSetting,
  type ParameterLike,
  parseValue,
  type Setting,
  type Settings,
  type SwitchSetting,
  switchSetting,
  type Value,
  type ValuesOf,
} from './settings.ts';
export { connectToSpeakers } from './sound-outputs.ts';
export { type RunningGame, type StartOptions, startGame } from './start-game.ts';
export { listenToSteering, type Steering, type SteeringOptions } from './steering.ts';
export { type SoundShape, Synth } from './synth.ts';
export { listenToTaps } from './taps.ts';
export type { BodyState, GameHook, GameState } from './test-hook.ts';
export type { ShellWords } from './words.ts';
