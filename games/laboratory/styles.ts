/** Styles of the laboratory, beside those of the shell. */
const styles = `
.game-bar .lab-back { display: flex; justify-content: center; align-items: center; gap: 6px; text-decoration: none; white-space: nowrap }
@media (max-width: 759px), (max-height: 479px) { .lab-back span { display: none } }
.lab-back:focus-visible, .lab-neighbours a:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px }
.game-card.lab-about h2 { display: block } .lab-about h2 b { font-weight: inherit }
/* A long title takes two lines beside the buttons. */
@media (min-width: 1000px) { .game-bar:has(.lab-back) { flex-wrap: nowrap } .game-bar:has(.lab-back) > :not(.game-title) { flex: none }
  .game-bar:has(.lab-back) .game-title { min-width: 0; font-size: clamp(15px, 1.6cqw, 20px); line-height: 1.2; max-height: 2.4em; overflow: hidden; text-wrap: balance } }
.lab-about p { margin: 2px 0 8px; font-size: 13px; line-height: 1.45; user-select: text }
.lab-about ul { margin: 2px 0 8px; padding-left: 16px; font-size: 13px; line-height: 1.4 }
.lab-neighbours { display: flex; justify-content: space-between; gap: 12px; font-size: 12px }
.lab-neighbours a { color: var(--dim); text-decoration: none; line-height: 1.35; text-wrap: balance } .lab-neighbours a + a { text-align: right }
.lab-checks { list-style: none; margin: 0; padding: 0 } .lab-checks li { display: flex; gap: 8px; padding: 3px 0 }
.lab-checks b { flex: none; width: 18px; height: 18px; border-radius: 50%; display: grid; place-items: center; font-size: 12px;
  background: #ffffff14; color: var(--dim) }
.lab-checks li[data-state=passed] b { background: #2f9e6e; color: #fff }
.lab-checks li[data-state=failed] b { background: #d0474f; color: #fff }
.lab-checks h3 { margin: 0; font-size: 12.5px; font-weight: 500 }
.lab-checks p { margin: 0; font-size: 12px; color: var(--dim); font-variant-numeric: tabular-nums; user-select: text }
.lab-code { position: absolute; left: 12px; bottom: calc(12px + var(--foot, 0px)); width: min(720px, calc(100% - 24px)); height: 56%; display: flex; flex-direction: column;
  gap: 8px; padding: 12px; box-sizing: border-box; border: 1px solid var(--line); border-radius: 14px; background: #0e1530f2; z-index: 1 }
@media (min-width: 760px) { .game:has(.game-side:not([hidden])) .lab-code { width: min(760px, calc(100% - 356px)) } }
@media (max-width: 759px), (max-height: 479px) { .lab-code { z-index: 3; height: calc(100% - 76px); bottom: 6px; left: 6px; width: calc(100% - 12px) }
  .game:has(> .lab-code:not([hidden])) > .game-timeline { visibility: hidden } }
.lab-code textarea { flex: 1; min-height: 0; resize: none; border: 0; border-radius: 8px; padding: 8px 10px; background: #0a1026; color: #dfe6ff;
  font: 12.5px/18px ui-monospace, SFMono-Regular, Menlo, Consolas, monospace; tab-size: 2; white-space: pre; overflow: auto; outline: none }
.lab-code textarea:focus-visible { box-shadow: 0 0 0 2px var(--accent) } .lab-code textarea::selection { background: #d0474f99 }
.lab-code-note { margin: 0; font-size: 12.5px; color: var(--dim); user-select: text; max-height: 72px; overflow: auto }
.lab-code-buttons { display: flex; flex-wrap: wrap; gap: 8px }
.lab-code-buttons button { border: 1px solid var(--line); border-radius: 9px; background: #ffffff14; color: var(--ink); font: inherit;
  font-size: 13px; padding: 7px 14px; min-height: 36px; cursor: pointer } .lab-code-buttons button:first-child { background: var(--accent); color: #1c1503 }
.lab-code-buttons button:last-child { margin-left: auto } .lab-code-buttons button:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px }
.lab-words { margin: 0; font-size: 12.5px; line-height: 1.45; color: var(--dim); font-variant-numeric: tabular-nums; user-select: text }
.lab-spoken { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); margin: 0 }
.lab-presets kbd { font: inherit; font-weight: 700; color: var(--accent) }
.lab-presets { display: flex; flex-wrap: wrap; gap: 6px; margin: 0 0 10px }
.lab-presets a, .lab-presets button { border: 1px solid var(--line); border-radius: 9px; background: #ffffff10; color: var(--ink); font: inherit; font-size: 12px;
  line-height: 1; padding: 8px 10px; cursor: pointer; text-decoration: none } .lab-presets :focus-visible { outline: 2px solid var(--accent) }
.lab-plot h2 span { flex-wrap: wrap; gap: 0 10px } .lab-plot h2 i { white-space: nowrap }
.lab-fold { margin: 0 auto 0 0; padding: 0; border: 0; background: none; color: inherit; font: inherit; font-weight: 600; text-align: left; cursor: pointer }
.lab-fold::before { content: '▾'; display: inline-block; width: 14px; color: var(--dim) } .lab-fold[aria-expanded=false]::before { content: '▸' }
.lab-fold:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px }
.lab-plot[data-folded] :is(h2 > :not(.lab-fold), .uplot) { display: none }
.lab-save[aria-pressed=true] { background: var(--accent); color: #1c1503 }
.lab-said { margin: -4px 0 8px; font-size: 12px; color: var(--dim) } .lab-said:empty { display: none } .lab-readout { font-weight: 500; font-variant-numeric: tabular-nums; color: var(--ink) }
.lab-save { border: 1px solid var(--line); border-radius: 7px; background: #ffffff10; color: var(--dim); font: inherit; font-size: 12px;
  padding: 1px 7px; cursor: pointer } .lab-save:focus-visible { outline: 2px solid var(--accent) }
@media (pointer: coarse) { .lab-presets kbd { display: none } .lab-presets :is(a, button) { min-height: 44px; min-width: 44px; box-sizing: border-box; line-height: 26px }
  .lab-neighbours a { display: flex; align-items: center; min-height: 44px; min-width: 44px } :is(.lab-save, .lab-fold) { min-height: 44px; min-width: 44px } .lab-code-buttons button { min-height: 44px } }
.lab-plot .u-cursor-x { position: absolute; left: 0; top: 0; height: 100%; border-right: 1px dashed #ffffff66; pointer-events: none }
.lab-plot .u-cursor-pt { position: absolute; top: 0; left: 0; border-radius: 50%; pointer-events: none; background-clip: padding-box !important }
.lab-plot .u-over { touch-action: pan-y } .lab-plot .u-off, .lab-plot .u-select { display: none }
`;

export function addLaboratoryStyles(): void {
  const sheet = document.createElement('style');
  sheet.textContent = styles;
  document.head.append(sheet);
}
