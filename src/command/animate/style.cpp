// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/animate/animation.hpp"

namespace magicmass::command {

const char* const animation_style = R"css(
:root { color-scheme: light dark; --ink: #1b1f24; --paper: #ffffff; --quiet: #57606a; --line: #6e7781;
  --block: #bcd9ec; --edge: #00527d; --ball: #e69b5f; --ball-edge: #8a3b00; --button: #f0f3f6; --focus: #0b4fa8; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6edf3; --paper: #0d1117; --quiet: #9da7b1; --line: #848d97; --block: #12486b; --edge: #79b8ff;
    --ball: #8a4413; --ball-edge: #ffb077; --button: #21262d; --focus: #79b8ff; }
}
* { box-sizing: border-box; }
body { margin: 0; color: var(--ink); background: var(--paper); font: 1rem/1.5 Georgia, "Times New Roman", serif; }
main { max-width: 66rem; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.4rem; margin: 0 0 0.5rem; overflow-wrap: anywhere; }
svg { display: block; width: 100%; height: auto; }
svg text { fill: var(--ink); font: 24px Georgia, serif; text-anchor: middle; }
.floor, .wall { stroke: var(--line); stroke-width: 2; }
.wall { stroke-width: 8; }
.block { fill: var(--block); stroke: var(--edge); stroke-width: 2; }
.ball { fill: var(--ball); stroke: var(--ball-edge); stroke-width: 2; }
.controls { display: flex; flex-wrap: wrap; gap: 0.5rem; align-items: center; }
button, select { font: inherit; color: inherit; background: var(--button); border: 1px solid var(--line);
  border-radius: 0.4rem; min-height: 2.75rem; padding: 0.3rem 0.8rem; }
#play { min-width: 5rem; font-weight: bold; }
:focus-visible { outline: 3px solid var(--focus); outline-offset: 2px; }
label { display: flex; gap: 0.5rem; align-items: center; }
.time { flex: 1 1 14rem; }
.time input { flex: 1; min-width: 0; min-height: 2.75rem; accent-color: var(--focus); }
#now { font-variant-numeric: tabular-nums; min-height: 1.5em; margin: 0.5rem 0; }
.quiet { color: var(--quiet); font-size: 0.9rem; }
kbd { font-family: ui-monospace, "DejaVu Sans Mono", monospace; border: 1px solid var(--line); border-radius: 0.25rem;
  padding: 0 0.3rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; min-width: 18rem; }
th, td { text-align: right; padding: 0.2rem 0.8rem 0.2rem 0; border-bottom: 1px solid var(--line); }
td:nth-child(n+3) { min-width: 5.5rem; }
th:first-child { text-align: left; }
.unseen { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
@media (max-width: 40rem) { svg text { font-size: 44px; } #now { min-height: 3em; } }
)css";

}  // namespace magicmass::command
