/** The report's style sheet; it follows the reader's light or dark setting. */
export const REPORT_STYLE = `
:root { color-scheme: light dark; --paper: #fbfbfa; --card: #fff; --ink: #1d2129; --soft: #667085; --line: #e4e7ec;
  --ours: #2563eb; --theirs: #98a2b3;
  --p0: #2563eb; --p1: #0d9488; --p2: #d97706; --p3: #9333ea; --p4: #dc2626; --p5: #4d7c0f; --p6: #0891b2; --p7: #be185d }
@media (prefers-color-scheme: dark) { :root { --paper: #101317; --card: #181c22; --ink: #e8eaed; --soft: #98a2b3;
  --line: #2c323b; --ours: #60a5fa; --theirs: #5b6472;
  --p0: #60a5fa; --p1: #2dd4bf; --p2: #fbbf24; --p3: #c084fc; --p4: #f87171; --p5: #a3e635; --p6: #22d3ee; --p7: #f472b6 } }
* { box-sizing: border-box }
body { margin: 0; background: var(--paper); color: var(--ink); font: 15px/1.5 system-ui, "Segoe UI", sans-serif }
main { max-width: 60rem; margin: 0 auto; padding: 2.5rem 1.25rem 4rem }
h1 { margin: 0; font-size: 1.75rem; letter-spacing: -0.01em }
h2 { margin: 0 0 .25rem; font-size: 1.05rem }
p { margin: .25rem 0 1rem; color: var(--soft) }
section { margin-top: 1.25rem; padding: 1.25rem 1.5rem; background: var(--card); border: 1px solid var(--line); border-radius: 12px }
.tiles { display: grid; grid-template-columns: repeat(auto-fill, minmax(17rem, 1fr)); gap: .75rem; margin-top: 1.5rem }
.tile { padding: .9rem 1.1rem; background: var(--card); border: 1px solid var(--line); border-radius: 12px }
.tile span { display: block; color: var(--soft); font-size: .8rem }
.tile b { font-size: 1.35rem; font-weight: 650; font-variant-numeric: tabular-nums }
svg { display: block; width: 100%; height: auto; overflow: visible }
svg text { fill: var(--ink); font: 12px system-ui, "Segoe UI", sans-serif; font-variant-numeric: tabular-nums }
svg .axis { fill: var(--soft) }
.grid { stroke: var(--line) }
.trace { fill: none; stroke: var(--ours); stroke-width: 1.2; stroke-linejoin: round }
.level { stroke: var(--ink); stroke-dasharray: 4 4; opacity: .55 }
svg .level-name { paint-order: stroke; stroke: var(--card); stroke-width: 4px }
.hover circle { fill: var(--ours); opacity: 0 } .hover circle:hover { opacity: 1 }
.bar, .ours { fill: var(--ours) } .theirs { fill: var(--theirs) } .bar:hover { opacity: .75 }
svg .note { fill: var(--soft) }
.legend { display: flex; flex-wrap: wrap; gap: .35rem 1.5rem; margin: .75rem 0 0; padding: 0; list-style: none }
.legend i { display: inline-block; width: .7rem; height: .7rem; margin-right: .45rem; border-radius: 3px }
.legend span { color: var(--soft) }
${[0, 1, 2, 3, 4, 5, 6, 7].map((i) => `svg .part-${i} { fill: var(--p${i}) } i.part-${i} { background: var(--p${i}) }`).join('\n')}
table { width: 100%; border-collapse: collapse; font-variant-numeric: tabular-nums }
td { padding: .35rem .75rem .35rem 0; border-top: 1px solid var(--line); vertical-align: top }
tr:first-child td { border-top: 0 }
td:nth-child(2) { white-space: nowrap; font-weight: 600 } td:nth-child(3) { color: var(--soft) }
`;
