"""report.py FOLDER ROOT [--docs]: tables and figure of one run of `./dev bench`, from the files it left in FOLDER.

Prints results.md, writes it and the figure's description, data and script into FOLDER; with --docs also puts the figure
and what compares into ROOT/docs, without the times at each accuracy, growth and parts. Times are processor times of one
core; those at an accuracy are interpolated on logarithms between the two settings on either side of it, the last time a
solver's error comes below. See bench/README.md.
"""

import csv
import datetime
import json
import math
import os
import pathlib
import re
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "tools"))
from monograph_figures import draw  # noqa: E402
from wrap import wrapped  # noqa: E402

OURS = ["exact", "exact after free response", "exact of frames"]
HEYOKA = "heyoka", "heyoka less calls"  # as it is called from Python, and without what those calls take
GENERIC = ["cvode", "arkode order 5", "arkode order 8", "odeint dopri5", HEYOKA[1]]
OPENSEES = ["opensees frames", "opensees matrices"]
ACCURACIES = [1e-3, 1e-6, 1e-9]
STYLES = {solver: {"tone": tone, "line": line, "mark": mark} for solver, tone, line, mark in (
    ("adaptive", "blue", "solid", "disc"), ("runge-kutta", "blue", "dashed", "circle"), ("cvode", "orange", "solid", "square"),
    ("arkode order 5", "orange", "dashed", "triangle"), ("arkode order 8", "purple", "solid", "diamond"),
    ("odeint dopri5", "green", "solid", "disc"), ("odeint all peaks", "green", "dashed", "circle"),
    (HEYOKA[0], "teal", "solid", "diamond"), (HEYOKA[1], "teal", "dashed", "triangle"),
    ("opensees frames", "black", "solid", "square"), ("opensees matrices", "grey", "dashed", "cross"))}


def read(path):
    if not path.exists():
        return []
    with path.open() as file:
        return list(csv.DictReader(file))


def seconds(value):
    for unit, factor in (("s", 1), ("ms", 1e-3), ("µs", 1e-6)):
        if value >= factor or unit == "µs":
            return f"{value / factor:.3g} {unit}"
    return ""


def factor(value):
    return f"{value:,.0f}" if value >= 100 else f"{value:.2g}"


def table(header, rows):
    """Markdown, its columns aligned, so that it reads in a terminal as well."""
    widths = [max(len(str(row[i])) for row in [header, *rows]) for i in range(len(header))]

    def line(row):
        cells = [str(cell).ljust(width) if i == 0 else str(cell).rjust(width)
                 for i, (cell, width) in enumerate(zip(row, widths))]
        return "| " + " | ".join(cells) + " |"

    rule = ["-" * width if i == 0 else "-" * (width - 1) + ":" for i, width in enumerate(widths)]
    return "\n".join([line(header), line(rule), *(line(row) for row in rows)]) + "\n"


class Runs:
    """The rows of one solver on one case, coarse to fine."""

    def __init__(self, rows):
        self.times = [float(row["minimum"]) for row in rows]
        self.errors = [max(float(row["error"]), 1e-16) for row in rows]
        self.settings = [row["setting"] for row in rows]

    def time_at(self, accuracy):
        """From which time on the error stays below; nothing where that was not seen."""
        above = [i for i, error in enumerate(self.errors) if error > accuracy]
        if not above:
            return self.times[0]
        i = above[-1]
        if i + 1 == len(self.errors):
            return None
        part = math.log(self.errors[i] / accuracy) / math.log(self.errors[i] / self.errors[i + 1])
        return math.exp((1 - part) * math.log(self.times[i]) + part * math.log(self.times[i + 1]))


def collect(rows, heyoka):
    cases = {}
    for row in rows:
        cases.setdefault(row["case"], {}).setdefault(row["solver"], []).append(row)
    for name, case in cases.items():
        calls = min((float(row["calls"]) for row in heyoka if row["case"] == name), default=0.0)
        if HEYOKA[0] in case:
            case[HEYOKA[1]] = [row | {key: float(row[key]) - calls for key in ("minimum", "median")}
                               for row in case[HEYOKA[0]]]
    return cases


def time_of(case, solver):
    return float(case[solver][0]["minimum"])


def accuracy_rows(name, case):
    rows = []
    for solver, runs in case.items():
        if solver in OURS:
            rows.append([f"{name}: {solver}", seconds(float(runs[0]["minimum"])), seconds(float(runs[0]["median"])), "",
                         "", "", runs[0]["impacts"]])
            continue
        found = Runs(runs)
        times = [found.time_at(accuracy) for accuracy in ACCURACIES]
        best = min(range(len(runs)), key=lambda i: found.errors[i])
        exact = time_of(case, "exact of frames" if solver == "opensees frames" else "exact")
        rows.append([solver, *(seconds(t) if t else "–" for t in times),
                     factor((times[1] or times[0]) / exact) if times[1] or times[0] else "–",
                     f"{found.errors[best]:.0e} at {found.settings[best]}, {seconds(found.times[best])}",
                     runs[best]["impacts"] or "–"])
    return rows


def calls_of(rows):
    """What is beside heyoka's integration: calls from and to Python, compilation; of the rows of one case."""
    if not rows:
        return ""
    compiled = [float(row["compilation"]) for row in rows]
    calls = min(float(row["calls"]) for row in rows)
    return (f"heyoka: {seconds(calls)} of its time are calls from and to Python, for {rows[0]['segments']} "
            f"segments of the record and the events; orders {rows[0]['order']} to {rows[-1]['order']}, whose steppers took "
            f"{seconds(compiled[0])} to {seconds(compiled[-1])} to compile, which is not in it." +
            (" With finer tolerances they would take too long to compile." if rows[-1]["given_up"] else "") + "\n\n")


def accuracies(cases, heyoka):
    text = ("Times to come to a peak force with a relative error of 1e-3, 1e-6, 1e-9; of `exact`, which has no setting, "
            "minimum and median of one solution. “×”: how many times as long as `exact`, at 1e-6, for OpenSees at "
            "1e-3.\n\n")
    for name, case in cases.items():
        rows = accuracy_rows(name, case)
        ours = [row[:3] + [row[6]] for row in rows if row[3] == "" and row[4] == ""]
        others = [row for row in rows if not (row[3] == "" and row[4] == "")]
        text += f"**{name}**\n\n"
        text += table(["", "minimum", "median", "impacts"], [[row[0].split(": ")[1], *row[1:]] for row in ours]) + "\n"
        text += table(["", *(f"at {accuracy:.0e}" for accuracy in ACCURACIES), "×", "least error", "impacts"],
                      others) + "\n"
        text += calls_of([row for row in heyoka if row["case"] == name])
    return text


def ratio_rows(cases):
    rows = []
    for name, case in cases.items():
        exact = time_of(case, "exact")
        row = [name, seconds(exact)]
        for solver, own in zip(OPENSEES, ("exact of frames", "exact")):
            if solver not in case:
                row.append("not run")
                continue
            runs = Runs(case[solver])
            time = runs.time_at(1e-3)
            best = f"{runs.errors[-1]:.1e} after {seconds(runs.times[-1])}"
            row.append(f"{factor(time / time_of(case, own))} ({seconds(time)})" if time else
                       f"> {factor(runs.times[-1] / time_of(case, own))} ({best})")
        generic = {solver: Runs(case[solver]).time_at(1e-6) for solver in GENERIC if solver in case}
        generic = {solver: time for solver, time in generic.items() if time}
        if generic:
            best = min(generic, key=generic.get)
            row.append(f"{factor(generic[best] / exact)} ({best}, {seconds(generic[best])})")
        else:
            row.append("none came so far")
        same = Runs(case["odeint all peaks"]).time_at(1e-6)
        row.append(f"{factor(same / exact)} ({seconds(same)})" if same else "–")
        rows.append(row)
    return rows


def ratios(cases):
    return ("How many times as long as `exact` others take; frames against the time of `exact` for the same frames.\n\n" +
            table(["case", "exact", "OpenSees, frames, 0.1 %", "OpenSees, fastest, 0.1 %", "best integrator, 1e-6",
                   "Odeint, all peaks, 1e-6"],
                  ratio_rows(cases)) + "\n")


def cost_model(growth, rates):
    if not growth:
        return ""
    baseline, *wide = [(row["instructions"], float(row["flops_per_second"])) for row in rates]
    fastest = (wide or [baseline])[-1]
    text = ("Arithmetic of one core, measured: " +
            ", ".join(f"{name} {rate / 1e9:.1f} Gflop/s" for name, rate in [baseline, *wide]) +
            f". The floor is the count at the rate of {fastest[0]}; exponents are between neighbouring rows, of the time "
            "and of the count.\n\n")
    header = ["growth", "impacts", "series steps", "time", "Mflop", f"floor", "time/floor", f"time/floor {baseline[0]}",
              "exponent", "of count"]
    rows, last = [], None
    for row in growth:
        time, count = float(row["minimum"]), float(row["free_flops"]) + float(row["contact_flops"])
        value = float(row["value"])
        exponents = ["", ""]
        if last and last[0] == row["growth"] and value > 0 and last[1] > 0 and row["growth"] != "gap":
            span = math.log(value / last[1])
            exponents = [f"{math.log(time / last[2]) / span:.2f}", f"{math.log(count / last[3]) / span:.2f}"]
        last = (row["growth"], value, time, count)
        label = f"{row['growth']} {row['value']}" if value > 0 or row["growth"] == "gap" else row["growth"]
        rows.append([label, row["impacts"], row["contact_steps"], seconds(time), f"{count / 1e6:.3g}",
                     seconds(count / fastest[1]), f"{time * fastest[1] / count:.3g}",
                     f"{time * baseline[1] / count:.3g}", *exponents])
    return text + table(header, rows) + "\n"


def hinges(rows):
    """What frames with hinges cost beside the same frames without; exponents are of the cost of an event."""
    if not rows:
        return ""
    table_rows, last = [], None
    for row in rows:
        count, events = int(row["hinges"]), int(row["events"])
        elastic, hinged, forgetful = (float(row[key]) for key in ("elastic", "hinged", "forgetful"))
        event = (hinged - elastic) / events
        exponent = f"{math.log(event / last[1]) / math.log(count / last[0]):.2f}" if last else ""
        last = count, event
        table_rows.append([f"{row['bays']} bays, {row['storeys']} storeys", count, events, seconds(elastic),
                           seconds(hinged), factor(hinged / elastic), seconds(event),
                           seconds((forgetful - elastic) / events), exponent])
    return ("Two frames 2 cm apart whose members all may yield, under 31 s of El Centro, beside the same frames without "
            "hinges. An event is a hinge, or several at once, that begins or ceases to flow, with and without contact; "
            "what one costs, and what it would if no set of flowing hinges were kept.\n\n" +
            table(["each frame", "hinges", "events", "elastic", "hinged", "×", "an event", "nothing kept", "exponent"],
                  table_rows) + "\n")


def plans(pair, blocks):
    """What buildings in plan cost: beside a row, and by how many there are."""
    if not pair:
        return ""
    plan, row = (float(of["time"]) for of in pair)
    text = ("Two buildings in plan that twist, shaken along both axes, beside a row's pair of as many degrees of freedom, "
            f"both under 10 s of El Centro with about a hundred impacts: {factor(plan / row)} times the time.\n\n" +
            table(["pair", "impacts", "time"], [[of["what"], of["impacts"], seconds(float(of["time"]))] for of in pair]) +
            "\nHouses of two storeys in plan, 1 cm from one another and 30 cm, where nothing touches. A house: of that time; "
            "an impact: what the narrow gaps take more, by their impacts.\n\n")
    rows = []
    for of in blocks:
        near, far, impacts, count = float(of["near"]), float(of["far"]), int(of["impacts"]), int(of["houses"])
        rows.append([f"{of['block']}, {count}", of["gaps"], impacts, seconds(near), seconds(far), seconds(far / count),
                     seconds((near - far) / impacts)])
    return text + table(["houses", "gaps", "impacts", "1 cm", "30 cm", "a house", "an impact"], rows) + "\n"


def beside_opensees(folder, name, title):
    """What one of the scripts that model a single case in OpenSees has printed."""
    path = folder / f"{name}.md"
    if not path.exists() or not (text := path.read_text().strip()):
        return ""
    return f"{title} beside OpenSees 3.7.1, error of each over the largest of its kind. {text}\n\n"


def parts(path):
    if not path.exists():
        return ""
    rows = []
    for of in json.loads(path.read_text())["benchmarks"]:
        scale = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}[of["time_unit"]]
        per_step = of.get("per_step")
        rows.append([of["name"].removeprefix("part/"), seconds_small(of["cpu_time"] * scale),
                     seconds_small(per_step) if per_step else ""])
    return table(["part", "time", "a step"], rows) + "\n"


def seconds_small(value):
    return f"{value * 1e9:.0f} ns" if value < 1e-6 else seconds(value)


def machine(folder):
    model = "unknown processor"
    cpuinfo = pathlib.Path("/proc/cpuinfo")
    if cpuinfo.exists():
        found = re.search(r"model name\s*:\s*(.*)", cpuinfo.read_text())
        model = found[1] if found else model
    compiler = (folder / "compiler.txt").read_text().strip() if (folder / "compiler.txt").exists() else "unknown"
    return (f"{datetime.date.today().isoformat()}, {model}, {len(os.sched_getaffinity(0))} cores, {compiler}. "
            "Load of the machine when the run ended: " + f"{os.getloadavg()[0]:.1f}.\n\n")


def figure(program, folder, cases):
    """Work-precision: error of the peak force against time, drawn by `bentur plot`."""
    times = [t for case in cases.values() for of in case.values() for t in Runs(of).times]
    ends = 10.0 ** math.floor(math.log10(min(times))), 10.0 ** math.ceil(math.log10(max(times)))
    panels = []
    for name, case in cases.items():
        curves = []
        for solver, style in STYLES.items():
            if solver in case:
                runs = Runs(case[solver])
                seen = [(t, max(e, 1e-13)) for t, e in zip(runs.times, runs.errors) if e < 1]
                curves.append({"label": solver, "x": [t for t, _ in seen], "y": [e for _, e in seen], **style})
        exact = time_of(case, "exact")
        curves.append({"label": "exact", "x": [exact, exact], "y": [1e-13, 1], "tone": "red", "width": 2})
        panels.append({"title": name, "curves": curves, "height": 5,
                       "x": {"label": "Time [s]", "logarithmic": True, "from": ends[0], "to": ends[1]},
                       "y": {"label": "Relative error of peak force [–]", "logarithmic": True, "from": 1e-13, "to": 1}})
    picture = folder / "work-precision.svg"
    draw(program, picture, panels, columns=min(3, len(panels)), width=26)
    return picture


def main():
    folder, root = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    rows = read(folder / "runs.csv")
    heyoka = read(folder / "heyoka.csv")
    cases = collect(rows, heyoka)
    text = machine(folder) + ratios(cases)
    if not any(solver in case for case in cases.values() for solver in OPENSEES):
        text += "OpenSees was not run: `./dev bench --peers` installs it.\n\n"
    if not heyoka:
        text += "heyoka was not run: `./dev bench --peers` installs it.\n\n"
    if not any("cvode" in case for case in cases.values()):
        text += "SUNDIALS was not installed (Debian: libsundials-dev).\n\n"
    sweep = folder / "sweep.txt"
    if sweep.exists():
        text += "Gap sweep on two threads: " + sweep.read_text().split(": ")[0].strip() + ".\n\n"
    details = "### Accuracy and time\n\n" + accuracies(cases, heyoka)
    details += "### Growth and the floor\n\n" + cost_model(read(folder / "growth.csv"), read(folder / "rates.csv"))
    details += "### Parts\n\n" + parts(folder / "parts.json")
    text += "### Hinges\n\n" + hinges(read(folder / "hinges.csv"))
    text += beside_opensees(folder, "hinged-frame", "A frame of two bays and two storeys with hinges against a wall,")
    text += "### Buildings in plan\n\n" + plans(read(folder / "plan_pair.csv"), read(folder / "blocks.csv"))
    text += beside_opensees(folder, "plan-pair", "Two buildings of three storeys in plan that strike,")
    text += beside_opensees(folder, "plan-pair-rubbing", "The same with friction of 0.3,")
    text, results = wrapped(text), wrapped(text + details)
    (folder / "results.md").write_text(results)
    print(results)
    svg = figure(root / "build/release/apps/bentur/bentur", folder, cases)
    print(f"bench: {svg}", file=sys.stderr)
    if "--docs" in sys.argv:
        page = root / "docs/performance.md"
        old = page.read_text()
        begin, end = "<!-- bench -->\n", "<!-- /bench -->"
        page.write_text(old[:old.index(begin) + len(begin)] + "\n" + text + old[old.index(end):])
        shutil.copyfile(svg, root / "docs/figures/work-precision.svg")


main()
