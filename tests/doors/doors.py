"""Doors to the same computation: command line, Python, page. Each gives the same numbers for every example, to the bit.

    doors.py compare FOLDER FOLDER   summaries of two doors, NAME.json each, as `bentur run NAME.toml -o` writes them

A door that is to be compared writes the summary of each of examples/*.toml into a folder; `summaries` writes the command
line's. What a summary says of the file its case was read from, and how long the run took, is left out.
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "examples").glob("*.toml"))
PLANS = sorted((ROOT / "examples" / "plan").glob("*.toml"))
CASES = sorted((ROOT / "tests" / "doors").glob("*.toml"))  # others, in which a door once stood alone


def numbers(summary):
    """A summary without what may differ between doors."""
    kept = {key: value for key, value in summary.items() if key not in ("case", "version")}
    kept["solver"] = {key: value for key, value in summary["solver"].items() if key != "wall_time"}
    kept["excitation"] = {key: value for key, value in summary["excitation"].items() if key != "file"}
    return kept


def differences(a, b, path=""):
    """Where two summaries differ, with both values. A number is the same where its bits are, but for the sign of zero."""
    if isinstance(a, dict) and isinstance(b, dict):
        for key in sorted({*a, *b}):
            if key not in a or key not in b:
                yield f"{path}.{key} is in one alone"
            else:
                yield from differences(a[key], b[key], f"{path}.{key}")
    elif isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        for i, (one, other) in enumerate(zip(a, b)):
            yield from differences(one, other, f"{path}[{i}]")
    elif a != b and not (isinstance(a, float) and isinstance(b, float) and math.isnan(a) and math.isnan(b)):
        yield f"{path}: {a!r} and {b!r}"


def count(value):
    """How many numbers there are."""
    if isinstance(value, dict):
        return sum(map(count, value.values()))
    if isinstance(value, list):
        return sum(map(count, value))
    return isinstance(value, int | float) and not isinstance(value, bool)


def command_line(program, case):
    """The summary of a case as the command line writes it beside its histories."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "run", case, "-q", "-o", folder], check=True, capture_output=True)
        return json.loads((pathlib.Path(folder) / "summary.json").read_text())


def summaries(program, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for case in EXAMPLES:
        (folder / f"{case.stem}.json").write_text(json.dumps(command_line(program, case)))


def compare(one, other):
    found, compared = [], 0
    for case in EXAMPLES:
        a, b = (numbers(json.loads((pathlib.Path(f) / f"{case.stem}.json").read_text())) for f in (one, other))
        found += [f"{case.stem}{line}" for line in differences(a, b)]
        compared += count(a)
    print("\n".join(found) or f"{compared} numbers of {len(EXAMPLES)} examples are the same")
    return bool(found)


if __name__ == "__main__":
    if len(sys.argv) == 4 and sys.argv[1] in ("compare", "summaries"):
        sys.exit(globals()[sys.argv[1]](*sys.argv[2:]))
    sys.exit(__doc__)
