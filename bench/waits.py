#!/usr/bin/env python3
"""What people wait for: seconds of processors and on the clock of whole commands, start of the program and all.

    python3 bench/waits.py PROGRAM [--against OLDER] [--repeats N] [--records FILE ...] [--only WORD]

Runs the built-in example, reports, frames with and without hinges, sweeps, incremental dynamic analyses and a block of 200
houses by PROGRAM, one thread each, and prints the least of N times (3 by default). OLDER, another build of it, takes
turns with PROGRAM, so that both see the same state of the machine. --records are those of the analysis of hinged
frames, El Centro in either polarity where there are none; --only takes the lines with that word alone.
"""

import argparse
import pathlib
import re
import tempfile

from houses import ROOT, case, spent

CASES = ROOT / "bench" / "cases"
EL_CENTRO = ROOT / "data" / "el-centro-1940-ns.csv"


def hinged(yields):
    """The pair of frames of bench/cases/hinged-6-6.toml, with its hinges or without."""
    text = (CASES / "hinged-6-6.toml").read_text(encoding="utf-8").replace("../../data/el-centro-1940-ns.csv",
                                                                           str(EL_CENTRO))
    return text if yields else re.sub(r", moment_capacity = [\d.]+, hardening = [\d.]+", "", text)


def hinged_study(folder, records):
    """An incremental dynamic analysis of that pair, 10 levels from 0.1 to 1 g."""
    given = [f'files = {[str(record.resolve()) for record in records]}'.replace("'", '"')] if records else \
            [f'files = ["{EL_CENTRO}"]', 'unit = "g"']
    both = '[[vary]]\nparameter = "excitation.polarity"\nvalues = ["as-recorded", "reversed"]\n'
    return "\n".join([f'case = "{folder}/hinged.toml"', "[ida]", 'intensity = "pga"', 'unit = "g"', "from = 0.1",
                      "to = 1.0", "count = 10", "[[vary]]", 'parameter = "excitation.file"', 'name = "record"', *given,
                      "" if records else both])


def tasks(folder, records):
    """Names and arguments of the commands, whose files are written into a folder."""
    def write(name, text):
        (folder / name).write_text(text, encoding="utf-8")
        return str(folder / name)

    elastic = write("elastic.toml", hinged(False))
    yields = write("hinged.toml", hinged(True))
    of_hinged = write("hinged-ida.toml", hinged_study(folder, records))
    block = write("block.toml", case(200))
    studies, out = ROOT / "examples" / "studies", ["-q", "--force", "--threads", "1", "-o", str(folder / "results.nc")]
    return [("first answer: the built-in example", ["run", "-q"]),
            ("report of two frames, with its figures", ["report", str(ROOT / "examples" / "two-frames-si.toml"), "--force",
                                                        "-o", str(folder / "report.html")]),
            ("report of buildings in plan", ["report", str(ROOT / "examples" / "plan" / "twisting-pair.toml"), "--force",
                                             "-o", str(folder / "report.html")]),
            ("frames of six storeys, elastic", ["run", "-q", elastic]),
            ("the same with 120 hinges", ["run", "-q", yields]),
            ("gap sweep, 10,000 runs", ["sweep", str(CASES / "gap-sweep.toml"), *out]),
            ("IDA of elastic frames, 128 runs", ["ida", str(studies / "two-frames-ida.toml"), *out]),
            (f"IDA of hinged frames, {10 * max(len(records), 2)} runs", ["ida", of_hinged, *out]),
            ("IDA in plan, 160 runs", ["ida", str(studies / "twisting-pair-ida.toml"), *out]),
            ("block of 200 houses", ["run", "-q", block])]


def main():
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--against", metavar="OLDER")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--records", nargs="+", type=pathlib.Path, default=[])
    parser.add_argument("--only", default="")
    given = parser.parse_args()
    programs = [given.program] + ([given.against] if given.against else [])
    print("| | processors [s] | clock [s] |" + (" older: processors [s] | clock [s] |" if given.against else ""))
    print("|---|---:|---:|" + ("---:|---:|" if given.against else ""))
    with tempfile.TemporaryDirectory() as folder:
        for name, arguments in tasks(pathlib.Path(folder), given.records):
            if given.only not in name:
                continue
            turns = [[spent([program, *arguments]) for program in programs] for _ in range(given.repeats)]
            least = [min(turn[p][i] for turn in turns) for p in range(len(programs)) for i in (0, 2)]
            print(f"| {name} |", " | ".join(f"{time:.3f}" for time in least), "|", flush=True)


if __name__ == "__main__":
    main()
