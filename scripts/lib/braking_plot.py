# SPDX-License-Identifier: BSD-3-Clause
"""Draws a comparison of braking distances with gnuplot: PREFIX.svg and PREFIX.png, from PREFIX.dat by PREFIX.gp."""
import subprocess

from braking import VERSIONS

# Columns: x, L1 to L4 (scaled), T2/ms. Bars are drawn from the sums' tops downwards, so that each shows its own part.
SCRIPT = """\
set terminal {terminal}
set output '{prefix}.{kind}'
set multiplot layout 1,2
set style fill solid border rgb 'white'
set boxwidth 0.42
set grid ytics lc rgb '#dddddd'
set xtics 1
set xlabel 'run (left bar: original, right bar: port)'
set xrange [0.4:{runs}.6]
set title '{title}'
set ylabel 'from the line to standstill / {unit}'
set yrange [0:*]
set key outside bottom center horizontal
set bmargin 7
plot '{prefix}.dat' using 1:($2+$3+$4+$5) with boxes lc rgb '#9aa5b1' title 'L4 braking', \\
     '' using 1:($2+$3+$4) with boxes lc rgb '#f2b134' title 'L3 detection', \\
     '' using 1:($2+$3) with boxes lc rgb '#d1495b' title 'L2 transport', \\
     '' using 1:2 with boxes lc rgb '#30638e' title 'L1 camera'
set title 'T2: published to callback'
set ylabel 'ms'
set logscale y
set yrange [*:*]
set xlabel 'run'
plot '{prefix}.dat' index 0 using (floor($1+0.5)):6 with linespoints pt 7 lc rgb '#777777' title 'original', \\
     '' index 1 using (floor($1+0.5)):6 with linespoints pt 5 lc rgb '#d1495b' title 'port'
unset multiplot
"""
TERMINALS = {"svg": "svg size 1100,480 font 'sans,12' background 'white'",
             "png": "pngcairo size 1100,480 font 'sans,10'"}
PLACES = {"original": -0.22, "ported": 0.22}


def draw(comparison, prefix, title, unit, scale):
    """Writes the data and both pictures. Raises FileNotFoundError without gnuplot, CalledProcessError when it fails."""
    with open(prefix + ".dat", "w", encoding="utf-8") as data:
        data.write("\n\n".join(block(comparison, version, scale) for version in VERSIONS))
    script = "\nreset\n".join(SCRIPT.format(terminal=terminal, kind=kind, prefix=prefix, title=title, unit=unit,
                                            runs=len(comparison.runs)) for kind, terminal in TERMINALS.items())
    with open(prefix + ".gp", "w", encoding="utf-8") as file:
        file.write(script)
    subprocess.run(["gnuplot", "-d", prefix + ".gp"], check=True)  # without the settings of ~/.gnuplot
    return [f"{prefix}.{kind}" for kind in TERMINALS]


def block(comparison, version, scale):
    lines = []
    for number, stop in enumerate(comparison.middles(version), 1):
        lengths = " ".join(f"{scale * length:.5f}" for length in stop.lengths)
        lines.append(f"{number + PLACES[version]} {lengths} {stop.times[1] * 1e3:.5f}\n")
    return "".join(lines)
