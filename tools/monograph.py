"""monograph.py BENTUR ROOT OUTPUT WORK [--record FILE]: docs/monograph from runs of examples/monograph.

Writes README.md and its figures into OUTPUT; data and scripts of the figures, cases and results stay in WORK. The section on
the choice of digitisation is made where FILE, another digitisation of El Centro 1940 (in g where it does not say), is given;
without, it stays as it stands in ROOT/docs/monograph/README.md.
"""

import importlib.util
import os
import pathlib
import shutil
import sys

if importlib.util.find_spec("netCDF4") is None:  # the distribution's Python has it
    if sys.executable == "/usr/bin/python3" or not os.path.exists("/usr/bin/python3"):
        sys.exit("python3-netcdf4 is not installed")
    os.execv("/usr/bin/python3", ["/usr/bin/python3", *sys.argv])

import monograph_page  # noqa: E402
from monograph_figures import Panel, draw  # noqa: E402
from monograph_runs import MOTIONS, PAIRS, SUFFIX, Runs, curves  # noqa: E402
from wrap import wrapped  # noqa: E402

NAMES = monograph_page.NAMES
BEGIN, END = "<!-- digitisation -->", "<!-- /digitisation -->"
FREE = [(r"^width = 0\.0 .*", "width = 100.0")]
OWN = [(r"^calibrate_period = .*\n", "")]
DYNAMIC = [*OWN, (r"^elastic_modulus", 'condensation = "dynamic"\nelastic_modulus')]


def series(histories, key, column=None):
    values = histories[key] if column is None else [row[column] for row in histories[key]]
    return list(zip(histories["time"], values))


def floors(histories, building):
    names = ["first floor", "second floor", "third floor"]
    count = len(histories[f"displacement_{building}"][0])
    return [(names[k], series(histories, f"displacement_{building}", k)) for k in range(count)]


def make(runs, output, name, panels, columns=1, height=4.6):
    """A figure of these panels, HEIGHT cm each, as OUTPUT/NAME.svg."""
    draw(runs.bentur, runs.folder / f"{name}.svg", [panel.described(height) for panel in panels], columns)
    shutil.copyfile(runs.folder / f"{name}.svg", output / f"{name}.svg")


def plot(runs, output, results, kind, name, *options):
    """A figure of bentur plot, as OUTPUT/NAME.svg."""
    runs.call("plot", f"{results}/histories.nc", kind, "-o", f"{name}.svg", *options)
    shutil.copyfile(runs.folder / f"{name}.svg", output / f"{name}.svg")


def history_figures(runs, output):
    """4.5-4.7, 4.9 and B.1-B.14: models 1 and 2 at the printed periods, touching."""
    time, displacement = "Time t [s]", "Displacement x [cm]"
    first = {"harmonic": 1, "El Centro": 8}
    seen = {}

    for motion in MOTIONS:
        case = f"m12-{SUFFIX[motion]}"
        runs.run(case, f"{case}-free", FREE)
        seen[motion] = runs.run(case, f"{case}-touching", figures=True)
        free, touching = runs.histories(f"{case}-free"), runs.histories(f"{case}-touching")
        for k, histories in enumerate((free, touching)):
            for building in (1, 2):
                panel = Panel(floors(histories, building), time, displacement, x_range=(0, 10), solid=True)
                make(runs, output, f"figure-b{first[motion] + 2 * k + building - 1:02}", [panel])
        for k, elevation in enumerate((100, 200, 300)):
            name = f"figure-b{first[motion] + 4 + k:02}"
            plot(runs, output, f"{case}-touching", "opening", f"{name}-opening", "--elevation", elevation)
            plot(runs, output, f"{case}-touching", "force", f"{name}-force", "--elevation", elevation)
        ground = series(touching, "ground_acceleration")
        if motion == "harmonic":
            amplitude = 1.0 / max(abs(value) for _, value in ground)
            moved = [(t, -a * amplitude) for t, a in ground]
            make(runs, output, "figure-4-05", [Panel([("", moved)], time, "Displacement [cm]", x_range=(0, 10)),
                                               Panel([("", ground)], time, "Acceleration [cm/s²]", x_range=(0, 10))], height=3.0)
            make(runs, output, "figure-4-07", [Panel([("", series(touching, "displacement_1", 1))], time, displacement, x_range=(0, 10))])
            plot(runs, output, f"{case}-touching", "impact", "figure-4-09")
        else:
            make(runs, output, "figure-4-06", [Panel([("", ground)], time, "Acceleration [cm/s²]", x_range=(0, 10))])
    return seen


def curve_figures(runs, found, output):
    """4.8, B.15, B.16 and the curves without a number, against the gap over the gap needed."""
    share = "Gap / gap needed [–]"

    def panel(motion, reading, values, y, title):
        lines = [(NAMES[pair], list(zip(c.relative(), values(c)))) for pair in PAIRS for c in [found[pair, motion, reading]]]
        return Panel(lines, share, y, title, x_range=(0, 1), band=(0.5, 0.7) if values is force else None)

    def force(c):
        return [max(row) / c.largest_force()[1] for row in c.force]

    for name, values, y in (("figure-4-08", force, "Peak force / its largest [–]"),
                            ("contact-duration", lambda c: c.durations(), "Time in contact [s]")):
        panels = [panel(motion, reading, values, y, f"{motion}, {monograph_page.READING[reading]}")
                  for reading in ("periods", "sections") for motion in MOTIONS]
        make(runs, output, name, panels, columns=2)
    for floor, name in ((0, "figure-b15"), (1, "figure-b16"), (2, "amplification-third-floor")):
        panels = []
        for motion in MOTIONS:
            for building, title in ((0, "Model 1"), (1, "its neighbour")):
                lines = []
                for pair in PAIRS:
                    c = found[pair, motion, "periods"]
                    if floor < len(c.amplification[building][0]):
                        lines.append((NAMES[pair], list(zip(c.relative(), [row[floor] for row in c.amplification[building]]))))
                panels.append(Panel(lines, share, "Amplification [–]", f"{motion}, {title}", x_range=(0, 1), rule=1))
            for panel in panels[-2:]:  # a pair has one scale
                panel.y_range = tuple(end(one.y_range[i] for one in panels[-2:]) for i, end in enumerate((min, max)))
        make(runs, output, name, panels, columns=2)


def period_figures(runs, output):
    """The gap needed against the period of Model 2, and that of twins against the delay."""
    by_period, by_delay = runs.gaps("equal-periods"), runs.gaps("identical")
    lines = {}
    for (varied, motion), record in by_period.items():
        lines.setdefault(motion, []).append((float(varied[0]) / 0.164, record["gap_needed"]))
    order = ["harmonic", "El Centro", "harmonic, no delay", "El Centro, no delay"]
    make(runs, output, "equal-periods", [Panel([(key, lines[key]) for key in order],
                                               "First period of Model 2 / that of Model 1 [–]", "Gap needed [cm]")])
    twins = [(float(varied[-1]), record["gap_needed"]) for (varied, _), record in by_delay.items()]
    make(runs, output, "twins", [Panel([("", twins)], "Delay [s]", "Gap needed [cm]")])
    return lines, twins


def own_touching(runs):
    """The histories of M1-2, harmonic, touching, from the sections."""
    runs.run("m12-harmonic", "m12-harmonic-own", OWN)
    return runs.histories("m12-harmonic-own")


def steps(step):
    return [(r"^duration = .*", f'duration = 10.0\nsolver = "runge-kutta"\nstep = {step}')]


def scheme(runs):
    """The monograph's own steps beside the exact solution: (step, summary or None, message)."""
    rows = []
    for step in ("0.06", "0.006", "0.0006", "0.00006"):
        message = runs.fails("m12-harmonic", "scheme", steps(step))
        rows.append((step, None if message else runs.run("m12-harmonic", "scheme", steps(step)), message))
    return rows


def sensitivity(runs):
    """(pair, motion, reading, width) -> summaries by the exact solver and by the adaptive one."""
    adaptive = (r"^duration = .*", 'duration = 10.0\nsolver = "adaptive"\ntolerance = 1e-12')
    rows = [(pair, motion, "periods", width) for pair in ("m12", "m32") for motion in MOTIONS for width in ("0.0", "0.2")]
    found = {}
    for pair, motion, reading, width in [*rows[:4], ("m14", "harmonic", "sections", "0.14"), *rows[4:]]:
        changes = [(r"^width = 0\.0 .*", f"width = {width}"), *(OWN if reading == "sections" else [])]
        found[pair, motion, reading, width] = [runs.run(f"{pair}-{SUFFIX[motion]}", "solver", c) for c in (changes, [*changes, adaptive])]
    return found


def main():
    bentur, root, output, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:5])
    record = pathlib.Path(sys.argv[6]).resolve() if sys.argv[5:6] == ["--record"] else None
    if record is not None and not record.is_file():
        sys.exit(f"no file {record}")
    output.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(work, ignore_errors=True)
    runs = Runs(bentur, root, work / "data")
    found = curves(runs)
    gathered = {
        "curves": found,
        "touching": history_figures(runs, output),
        "histories": {"printed periods": runs.histories("m12-harmonic-touching"), "own sections": own_touching(runs)},
        "impacts": runs.impacts("m12-harmonic-touching"),
        "printed": {pair: runs.run(f"{pair}-el-centro", f"{pair}-calibrated") for pair in PAIRS},
        "own": {pair: runs.run(f"{pair}-el-centro", f"{pair}-own", OWN) for pair in PAIRS},
        "dynamic": {pair: runs.run(f"{pair}-el-centro", f"{pair}-dynamic", DYNAMIC) for pair in PAIRS},
        "scheme": scheme(runs),
        "sensitivity": sensitivity(runs),
        "free steps": [runs.run("m12-harmonic", "free-steps", [*FREE, *steps("0.006")]), runs.run("m12-harmonic", "free-exact", FREE)],
    }
    curve_figures(runs, found, output)
    gathered["periods"], gathered["twins"] = period_figures(runs, output)
    if record is not None:
        others = Runs(bentur, root, work / "record", record)
        motion = others.run("m12-el-centro", "read")["excitation"]
        digitisation = monograph_page.digitisation(found, curves(others), record.name, motion)
    else:
        page = root / "docs/monograph/README.md"
        old = page.read_text() if page.is_file() else ""
        digitisation = old.split(BEGIN)[1].split(END)[0].strip("\n") if BEGIN in old else monograph_page.NO_DIGITISATION
    text = monograph_page.page(gathered, f"{BEGIN}\n{digitisation}\n{END}")
    temporary = output / "README.md.part"
    temporary.write_text(wrapped(text))
    temporary.replace(output / "README.md")


main()
