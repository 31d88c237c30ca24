/** Styles of the laboratory, beside those of the shell. */
const styles = `
.game .game-side { width: 320px } .game .game-side .lil-gui { --width: 320px }
@media (min-width: 760px) and (min-height: 480px) { .game:has(.game-side:not([hidden])) > .game-bar { right: 344px } }
.lab-back { pointer-events: auto; color: var(--accent); font-weight: 600; text-decoration: none; margin-right: 6px; white-space: nowrap }
.lab-back:focus-visible, .lab-neighbours a:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px }
.lab-about p { margin: 2px 0 8px; font-size: 13px; line-height: 1.45; user-select: text }
.lab-about ul { margin: 2px 0 8px; padding-left: 16px; font-size: 13px; line-height: 1.4 }
.lab-neighbours { display: flex; justify-content: space-between; gap: 12px; font-size: 12px }
.lab-neighbours a { color: var(--dim); text-decoration: none; overflow: hidden; text-overflow: ellipsis; white-space: nowrap }
.lab-checks { list-style: none; margin: 0; padding: 0 } .lab-checks li { display: flex; gap: 8px; padding: 3px 0 }
.lab-checks b { flex: none; width: 18px; height: 18px; border-radius: 50%; display: grid; place-items: center; font-size: 12px;
  background: #ffffff14; color: var(--dim) }
.lab-checks li[data-state=passed] b { background: #2f9e6e; color: #fff }
.lab-checks li[data-state=failed] b { background: #d0474f; color: #fff }
.lab-checks h3 { margin: 0; font-size: 12.5px; font-weight: 500 }
.lab-checks p { margin: 0; font-size: 12px; color: var(--dim); font-variant-numeric: tabular-nums; user-select: text }
.lab-plot h2 span { flex-wrap: wrap; gap: 0 10px } .lab-plot h2 i { white-space: nowrap }
.lab-plot h2 b { font-weight: 600; margin-right: auto } .lab-readout { font-weight: 500; font-variant-numeric: tabular-nums; color: var(--ink) }
.lab-save { border: 1px solid var(--line); border-radius: 7px; background: #ffffff10; color: var(--dim); font: inherit; font-size: 11px;
  padding: 1px 7px; cursor: pointer } .lab-save:focus-visible { outline: 2px solid var(--accent) }
.lab-plot .u-cursor-x { position: absolute; left: 0; top: 0; height: 100%; border-right: 1px dashed #ffffff66; pointer-events: none }
.lab-plot .u-cursor-pt { position: absolute; top: 0; left: 0; border-radius: 50%; pointer-events: none; background-clip: padding-box !important }
.lab-plot .u-over { touch-action: pan-y } .lab-plot .u-off, .lab-plot .u-select { display: none }
`;

export function addLaboratoryStyles(): void {
  const sheet = document.createElement('style');
  sheet.textContent = styles;
  document.head.append(sheet);
}
