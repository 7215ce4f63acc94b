// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc::rewriter {

/// The page's whole style: no external fonts, scripts or images; light or dark as the reader's system.
constexpr const char* html_style = R"css(
:root { color-scheme: light dark; --ink: #1c2128; --faint: #667080; --line: #d8dee6; --paper: #fff; --panel: #f6f8fa;
  --good: #1a7f45; --fair: #9a6700; --bad: #c0342b; --none: #8a94a3; --add: #e3f6e8; --del: #fde8e6; --gap: #eef1f5; }
@media (prefers-color-scheme: dark) { :root { --ink: #e3e8ee; --faint: #93a0b0; --line: #343c46; --paper: #14181d;
  --panel: #1c2128; --good: #4cc47a; --fair: #d9a53a; --bad: #f0776d; --none: #75808e; --add: #12331f; --del: #3d1a1a; --gap: #20262e; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 2rem 4rem; max-width: 92rem; background: var(--paper); color: var(--ink);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; }
h1 { font-size: 1.6rem; margin: 0 0 .6rem; } h2 { font-size: 1.3rem; margin: 2.4rem 0 .5rem; } h3 { font-size: 1.08rem; margin: 2rem 0 .6rem; }
h2.package { border-top: 2px solid var(--line); padding-top: 1.6rem; }
.meta { display: grid; grid-template-columns: max-content 1fr; gap: .1rem 1rem; margin: 0; color: var(--faint); font-size: .92rem; }
.meta dt { font-weight: 600; } .meta dd { margin: 0; overflow-wrap: anywhere; }
.filters { position: sticky; top: 0; z-index: 1; display: flex; flex-wrap: wrap; gap: .4rem 1.4rem; align-items: center; margin: 1.4rem 0 0; padding: .6rem 1rem;
  background: var(--panel); border: 1px solid var(--line); border-radius: 8px; font-size: .92rem; }
.filters[hidden] { display: none; } .filters input { width: 17rem; } .filters input, .filters select { font: inherit; } .filters output { margin-left: auto; color: var(--faint); }
section p { max-width: 62rem; }
h4 { font: 600 .9rem/1.4 ui-monospace, "DejaVu Sans Mono", monospace; margin: 0; }
.lead { color: var(--faint); margin: 0 0 1.2rem; }
code, .mono { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: .87em; }
.cards { display: flex; flex-wrap: wrap; gap: 1rem; }
.card { flex: 1 1 18rem; border: 1px solid var(--line); border-radius: 8px; padding: .9rem 1.1rem; background: var(--panel); }
.card b { font-size: 1.5rem; margin-right: .4rem; } .card p { margin: .5rem 0 0; color: var(--faint); }
.bar { display: flex; height: .6rem; border-radius: 4px; overflow: hidden; margin-top: .6rem; background: var(--line); }
.bar i { display: block; }
.good { color: var(--good); } .fair { color: var(--fair); } .bad { color: var(--bad); } .none { color: var(--none); }
i.good { background: var(--good); } i.fair { background: var(--fair); } i.bad { background: var(--bad); } i.none { background: var(--none); }
table.sites { width: 100%; border-collapse: collapse; }
.sites th { text-align: left; font-weight: 600; color: var(--faint); font-size: .85rem; border-bottom: 2px solid var(--line); padding: .3rem .8rem .3rem 0; }
.sites td { vertical-align: top; border-bottom: 1px solid var(--line); padding: .45rem .8rem .45rem 0; }
.level { font-weight: 600; white-space: nowrap; }
.sites td.num, .sites th.num { text-align: right; font-variant-numeric: tabular-nums; }
.sites td.num { white-space: nowrap; } .sites tfoot td { font-weight: 600; border-bottom: 0; }
.sites td:first-child { white-space: nowrap; }
.sites tr.why td { border-bottom: 1px solid var(--line); padding-top: 0; }
.sites tr.has-why td { border-bottom: 0; }
.why ol { margin: .3rem 0 .2rem; padding-left: 1.4rem; color: var(--faint); }
.why .memory { color: var(--faint); }
a { color: inherit; text-decoration-color: var(--line); text-underline-offset: 3px; }
details.file { border: 1px solid var(--line); border-radius: 8px; margin-bottom: 1rem; overflow: hidden; }
details.file > summary { cursor: pointer; padding: .6rem 1rem; background: var(--panel); display: flex; gap: 1rem; align-items: baseline; }
details.file > summary span { font-size: .85rem; }
table.diff { width: 100%; border-collapse: collapse; table-layout: fixed; font: 12.5px/1.5 ui-monospace, "DejaVu Sans Mono", monospace; }
.diff td { padding: 0 .5rem; white-space: pre-wrap; overflow-wrap: anywhere; vertical-align: top; }
.diff td.n { width: 3.6rem; text-align: right; color: var(--faint); user-select: none; }
.diff .add { background: var(--add); } .diff .del { background: var(--del); } .diff .pad { background: var(--gap); }
.diff tr.cut td { background: var(--gap); color: var(--faint); text-align: center; }
)css";

}  // namespace tzc::rewriter
