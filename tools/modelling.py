"""modelling.py BENTUR ROOT PAGE WORK [--records FOLDER]: the tables of docs/modelling.md from examples/studies/modelling.

PAGE is written anew between its marks, the words around them stay; results of the studies stay in WORK. Without FOLDER the
ground motions are those of ROOT/records/far-field.
"""

import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

if importlib.util.find_spec("netCDF4") is None:  # the distribution's Python has it
    if sys.executable == "/usr/bin/python3" or not os.path.exists("/usr/bin/python3"):
        sys.exit("python3-netcdf4 is not installed")
    os.execv("/usr/bin/python3", ["/usr/bin/python3", *sys.argv])

import netCDF4  # noqa: E402
import numpy  # noqa: E402

from monograph_page import table  # noqa: E402

PAIRS = [("../eight-and-six.toml", "frames of 8 and 6 storeys"), ("masonry-and-frame.toml", "masonry beside a frame"),
         ("heavy-and-light.toml", "walls beside light steel")]
QUANTITIES = [("peak_displacement", "displacement"), ("peak_drift_ratio", "drift"), ("peak_acceleration", "acceleration")]


def sweep(bentur, root, work, study, records):
    """The study with each pair: for each a dictionary of (variant, record, ...) arrays, and the variants' labels."""
    text = (root / f"examples/studies/modelling/{study}.toml").read_text()
    found = []
    for case, _ in PAIRS:
        absolute = (root / "examples/studies/modelling" / case).resolve()
        changed = re.sub(r'^case = .*$', lambda _: f"case = {json.dumps(str(absolute))}", text, flags=re.MULTILINE)
        changed = re.sub(r'^files = .*$', lambda _: f"files = {json.dumps(str(records / '*.csv'))}", changed, flags=re.MULTILINE)
        name = f"{study}-{absolute.stem}"
        (work / f"{name}.toml").write_text(changed)
        result = subprocess.run([bentur, "sweep", f"{name}.toml", "-o", f"{name}.nc"], cwd=work, capture_output=True, text=True)
        if result.returncode != 0:
            sys.exit(f"bentur sweep {work / name}.toml\n{result.stderr}")
        with netCDF4.Dataset(work / f"{name}.nc") as data:
            data.set_auto_mask(False)
            if (data["status"][:] != 0).any():
                sys.exit(f"{work / name}.nc: not every run is done")
            # [:, :, 0]: there is one peak ground acceleration. Then the largest of floors, storeys or contact points.
            one = {key: numpy.stack([data[f"{key}_{n}"][:, :, 0].max(axis=-1) for n in (1, 2)], axis=-1) for key, _ in QUANTITIES}
            for key in ("peak_force", "gap_needed"):
                one[key] = data[key][:, :, 0].max(axis=-1)[..., None]
            one["pounds"] = (data["impacts"][:, :, 0] > 0).any(axis=-1)
            labels = [str(label) for label in data[data["impacts"].dimensions[0]][:]]
        found.append(one)
    return found, labels


def change(ratio):
    percent = round(100 * (ratio - 1))
    return f"{percent:+d}" if percent else "0"


def spread(values):
    """The median and the range from the 5th to the 95th percentile, as changes in per cent."""
    low, middle, high = numpy.percentile(values, (5, 50, 95))
    return f"{change(middle)} ({change(low)} to {change(high)})"


def beside_first(found, key, variant):
    """VARIANT over the first one: of every record in which the pair meets in both, every building and every pair."""
    ratios = []
    for one in found:
        both = one["pounds"][variant] & one["pounds"][0]
        ratios.append((one[key][variant] / one[key][0])[both].ravel())
    return numpy.concatenate(ratios)


def contacts(found, labels):
    rows = []
    for variant, label in enumerate(labels[1:], 1):
        cells = [spread(beside_first(found, key, variant)) for key, _ in QUANTITIES]
        # An impact without duration has no force.
        force = "–" if label.startswith("law: restitution") else spread(beside_first(found, "peak_force", variant))
        rows.append([label, *cells, force])
    return table(["change [%]", *(name for _, name in QUANTITIES), "contact force"], rows)


def dampings(found, labels):
    rows = []
    for variant, label in enumerate(labels[1:], 1):
        keys = ["gap_needed", *(key for key, _ in QUANTITIES), "peak_force"]
        rows.append([label, *(spread(beside_first(found, key, variant)) for key in keys)])
    return table(["change [%]", "gap needed", *(name for _, name in QUANTITIES), "contact force"], rows)


def motions(found):
    """What the record alone does: of the first contact, the answers over their own median."""
    rows = []
    for (_, name), one in zip(PAIRS, found):
        pounds = one["pounds"][0]
        cells = []
        for key in ["gap_needed", *(key for key, _ in QUANTITIES), "peak_force"]:
            values = one[key][0][pounds]
            cells.append(spread(values / numpy.median(values, axis=0)))
        rows.append([name, f"{pounds.sum()} of {pounds.size}", *cells])
    return table(["change [%]", "records that pound", "gap needed", *(name for _, name in QUANTITIES), "contact force"], rows)


def main():
    bentur, root, page, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:5])
    records = pathlib.Path(sys.argv[6]).resolve() if sys.argv[5:6] == ["--records"] else root / "records/far-field"
    if not any(records.glob("*.csv")):
        sys.exit(f"no ground motions in {records}; ./dev records fetches them")
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    by_contact, labels = sweep(bentur, root, work, "contacts", records)
    by_damping, ratios = sweep(bentur, root, work, "damping", records)
    text = page.read_text()
    for mark, lines in (("contacts", contacts(by_contact, labels)), ("damping", dampings(by_damping, ratios)),
                        ("motions", motions(by_contact))):
        begin, end = f"<!-- {mark} -->\n", f"\n<!-- /{mark} -->"
        if text.count(begin) != 1 or text.count(end) != 1:
            sys.exit(f"{page} has no place for {mark}")
        text = text.split(begin)[0] + begin + lines + end + text.split(end)[1]
    temporary = page.with_suffix(".part")
    temporary.write_text(text)
    temporary.replace(page)


main()
