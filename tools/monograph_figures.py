"""Figures of docs/monograph that bentur plot does not offer, by gnuplot, in the same style; data and script stand beside each."""

import math
import subprocess

STYLES = [("#000000", "solid"), ("#b4540a", "(9,4)"), ("#1f5fa8", "(9,3,2,3)"), ("#5f6b76", "(3,3)")]
PIXELS = 333 / 8.8  # a cm


class Panel:
    """Curves (label, [(x, y), ...]) in one frame; x_range and y_range None: from the data. `solid`: long histories, where dashes
    would blur; the first curve then lies on top. `band`: what a claim says of x, shaded, with a mark at the largest value of
    each curve; `rule`: a line at this y, where nothing changes."""

    def __init__(self, curves, x, y, title="", x_range=None, y_range=None, solid=False, band=None, rule=None):
        self.band, self.rule = band, rule
        self.curves, self.x, self.y, self.title, self.solid = curves, x, y, title, solid
        self.x_range = x_range or bounds([p[0] for _, c in curves for p in c], 0)
        self.y_range = y_range or bounds([p[1] for _, c in curves for p in c], 0.06)


def bounds(values, margin):
    low, high = min(values), max(values)
    low = 0 if 0 <= low < 0.5 * high else low
    room = margin * (high - low)
    return (low if low == 0 else low - room), high + room


def tics(low, high, most):
    """gnuplot's xtics argument: at most MOST round steps."""
    step = (high - low) / most
    size = 10 ** math.floor(math.log10(step))
    step = next(m * size for m in (1, 2, 5, 10) if m * size >= step * (1 - 1e-9))
    digits = max(0, -math.floor(math.log10(step) + 1e-9))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return "(" + ", ".join(f"'{k * step:.{digits}f}' {k * step:.10g}".replace("'-0'", "'0'") for k in range(first, last + 1)) + ")"


def draw(folder, name, panels, columns=1, width=17.0, height=4.6):
    """NAME.dat, NAME.gp and NAME.svg in FOLDER; WIDTH of all and HEIGHT of a panel in cm."""
    rows = (len(panels) + columns - 1) // columns
    labels = [label for label, _ in max((panel.curves for panel in panels), key=len)]
    legend = 0.7 if labels[0] else 0.15
    titles = 0.55 if any(panel.title for panel in panels) else 0.1
    left, right, bottom, between = 1.55, 0.35, 1.15, 0.15
    panel_width = width / columns
    total = legend + rows * (titles + height + bottom) + between
    blocks = []
    lines = [
        "# Draws the figure whose data stand beside this script (gnuplot 5.4 or newer, in this folder): gnuplot THIS", "reset",
        "set encoding utf8", f"data = './{name}.dat'",
        f"set terminal svg size {round(width * PIXELS)},{round(total * PIXELS)} noenhanced "
        "font 'Helvetica,Arial,sans-serif,10.67' linewidth 1 background rgb 'white'",
        f"set output './{name}.svg'", "set multiplot", "unset key", "set border 31 lw 0.7",
        "set tics in scale 0.5,0.3 front", "set xtics offset 0,0.3", "set ytics offset 0.4,0"]

    def at(x, y):  # cm from the top left
        return f"screen {x / width:.5f}, screen {1 - y / total:.5f}"

    for i, panel in enumerate(panels):
        x0 = i % columns * panel_width
        top = legend + i // columns * (titles + height + bottom) + titles
        lines += ["", "unset label", "unset arrow", "unset object",
                  f"set lmargin at screen {(x0 + left) / width:.5f}",
                  f"set rmargin at screen {(x0 + panel_width - right) / width:.5f}",
                  f"set tmargin at screen {1 - top / total:.5f}",
                  f"set bmargin at screen {1 - (top + height) / total:.5f}",
                  f"set xrange [{panel.x_range[0]:.10g}:{panel.x_range[1]:.10g}]",
                  f"set yrange [{panel.y_range[0]:.10g}:{panel.y_range[1]:.10g}]",
                  f"set xtics {tics(*panel.x_range, 10 if columns == 1 else 6)}",
                  f"set ytics {tics(*panel.y_range, 5)}",
                  f"set label '{panel.x}' at {at(x0 + (left + panel_width - right) / 2, top + height + 0.8)} center",
                  f"set label '{panel.y}' at {at(x0 + 0.3, top + height / 2)} center rotate"]
        if panel.band:
            low, high = panel.band
            lines.append(f"set object {i + 1} rectangle from {low}, graph 0 to {high}, graph 1 fc rgb '#f2d3b8' fs solid noborder back")
        if panel.rule is not None:
            lines.append(f"set arrow from graph 0, first {panel.rule} to graph 1, first {panel.rule} nohead back lc rgb '#5f6b76' lw 0.7")
        if panel.title:
            lines.append(f"set label '{panel.title}' at {at(x0 + (left + panel_width - right) / 2, top - 0.25)} center")
        if i == 0 and labels[0]:
            x = left
            for label, (colour, dash) in zip(labels, STYLES):
                dash = "solid" if panel.solid else dash
                lines.append(f"set arrow from {at(x, 0.35)} to {at(x + 0.8, 0.35)} nohead lc rgb '{colour}' dt {dash} lw 1.01")
                lines.append(f"set label '{label}' at {at(x + 0.95, 0.35)} left")
                x += 1.5 + 0.19 * len(label)
        plots = []
        for (label, points), (colour, dash) in zip(panel.curves, STYLES):
            plots.append(f"data index {len(blocks)} using 1:2 with lines lc rgb '{colour}' dt {dash} lw 1.01")
            blocks.append(f"# {panel.title} {label}; columns: {panel.x}, {panel.y}\n"
                          + "".join(f"{a:.8g} {b:.8g}\n" for a, b in points))
        for (_, points), (colour, _) in zip(panel.curves, STYLES):
            if panel.band and points:
                x, y = max(points, key=lambda point: point[1])
                lines.append(f"set label '' at {x:.8g},{y:.8g} point pt 7 ps 0.5 lc rgb '{colour}' front")
        if panel.solid:
            plots = [plot.replace(f"dt {dash}", "dt solid") for plot, (_, dash) in zip(plots, STYLES)][::-1]
        lines.append("plot " + ", \\\n     ".join(plots))
    lines += ["unset multiplot", "unset output", ""]
    (folder / f"{name}.dat").write_text("\n\n".join(blocks))
    (folder / f"{name}.gp").write_text("\n".join(lines))
    subprocess.run(["gnuplot", f"{name}.gp"], cwd=folder, check=True)
