"""instructions.py BENTUR CASE...: where the instructions of one solution by `exact` go, in millions, by callgrind.

Lines overlap in nothing. What is counted is solve() alone, without reading, assembling and telling; by line the response
with contact, FreeSolution::solve().
"""

import pathlib
import re
import subprocess
import sys
import tempfile

# A line of the table: functions whose costs it is made of, with all that they call.
LINES = {
    "flying, and which flights are quiet": ["StepBuffer::fly_on", "StepBuffer::fly", "PoundingRun::quiet"],
    "steps near contact: power series, ends, how far from chords": ["Run::step"],
    "… which laws may change, and when; impacts followed": ["Run::look"],
    "… the state at that instant, and when bodies touched": ["Expansion::evaluate", "Elements::note_touches"],
    "… changes of laws": ["Run::arrived"],
    "… kept for peaks": ["StepBuffer::add"],
    "peaks: values at all ends, bounds, what may exceed": ["PeakSearch::take"],
    "… what is looked into": ["Run::settle_peaks"],
}


def collected(bentur, case, function, folder):
    """@return all instructions within the function, and those of each function, inclusive"""
    out = folder / "callgrind.out"
    subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", f"--toggle-collect={function}",
                    bentur, "run", "--quiet", case], check=True, capture_output=True)
    told = subprocess.run(["callgrind_annotate", "--inclusive=yes", "--threshold=100", out], check=True,
                          capture_output=True, text=True).stdout
    total, costs = 0, {}
    for line in told.split("\n"):
        if not (m := re.match(r"\s*([\d,]+) \(\s*[\d.]+%\)\s+(.*)", line)):
            continue
        count = int(m.group(1).replace(",", ""))
        if m.group(2).startswith("PROGRAM TOTALS"):
            total = count
        elif (name := re.search(r"bentur::engine::(\w+::\w+)\(", m.group(2))) and "'2" not in m.group(2):
            costs[name.group(1)] = costs.get(name.group(1), 0) + count
    return total, costs


def main():
    bentur, cases = sys.argv[1], [pathlib.Path(name) for name in sys.argv[2:]]
    rows = {"all": [], "of which without contact": [], **{line: [] for line in LINES}, "the rest": []}
    with tempfile.TemporaryDirectory() as name:
        for case in cases:
            total, _ = collected(bentur, case, "bentur::solve(bentur::Problem*", pathlib.Path(name))
            contact, costs = collected(bentur, case, "bentur::FreeSolution::solve(*", pathlib.Path(name))
            rows["all"].append(total)
            rows["of which without contact"].append(total - contact)
            parts = [sum(costs.get(function, 0) for function in functions) for functions in LINES.values()]
            for line, part in zip(LINES, parts):
                rows[line].append(part)
            rows["the rest"].append(contact - sum(parts))
    print("| |", " | ".join(case.stem for case in cases), "|")
    print("|---|" + "---:|" * len(cases))
    for line, counts in rows.items():
        print(f"| {line} |", " | ".join(f"{count / 1e6:.2f}" for count in counts), "|")


if __name__ == "__main__":
    main()
