/**
 * Styles where the system forces its own colours, as for high contrast: it leaves out backgrounds, so what shows a value or
 * a state by them keeps its colours, and fields get a border.
 */
export const FORCED_COLORS = `
@media (forced-colors: active) {
  .game-side, .game-timeline output { background: Canvas }
  .game-side .lil-gui input[type=checkbox] { appearance: auto; forced-color-adjust: auto } .game-side .lil-gui input[type=checkbox]::before { content: none }
  .game-side .lil-gui :is(input:not([type=checkbox]), .lil-slider, .lil-display, button), .game-card :is(input, select) { border: 1px solid ButtonBorder }
  .game :is(.game-profile i, .game-timeline input, .uplot, [data-gauge], [data-gauge] *) { forced-color-adjust: none }
  .game .game-card h2 i::before { forced-color-adjust: none }
  .game .game-card h2 i::before, .game .game-profile i, .game [data-gauge] { outline: 1px solid CanvasText }
  .game :is(.uplot, .game-profile i, .game-timeline input) { background-color: #141b36 }
  .game button[aria-pressed=true] { forced-color-adjust: none; background: Highlight; color: HighlightText }
}
`;
