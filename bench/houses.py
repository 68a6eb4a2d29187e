#!/usr/bin/env python3
"""How what `bentur run` takes grows with the houses of a block.

    python3 bench/houses.py PROGRAM [HOUSES ...]

Makes blocks of so many houses (100, 200, 500 and 1,000 by default) of two storeys, some 12 m by 10 m, in rows of 32,
1 cm from one another, runs 5 s of El Centro by PROGRAM, without results in files and with them, and prints a table:
processor time, that on the clock, and largest memory of the whole program.
"""

import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
COLUMNS = 32
LENGTH, WIDTH, CLEAR = 10.0, 12.0, 0.01


def case(houses):
    """The text of a case of so many houses, no two of one stiffness."""
    numbers = random.Random(54)
    text = ['[units]\nlength = "m"\nforce = "kN"\n[plan]\nclearance = 0.1\n'
            'contact = { law = "linear", stiffness = 4e5 }\n']
    for n in range(houses):
        left, low = n % COLUMNS * (LENGTH + CLEAR), n // COLUMNS * (WIDTH + CLEAR)
        text.append(f'[[building]]\nname = "H{n}"\ndamping = 0.05\n[building.plan]\ncorner = [{left}, {low}]\n'
                    f'size = [{LENGTH}, {WIDTH}]\nstorey_heights = [3.0, 3.0]\nmasses = [120.0, 100.0]\n')
        for along, at in (("x", 1.0), ("x", WIDTH - 1), ("y", 1.0), ("y", LENGTH - 1)):
            stiffness = [round(numbers.uniform(2e4, 4e4)) for _ in range(2)]
            text.append(f'[[building.plane]]\nalong = "{along}"\nat = {at}\nstiffnesses = {stiffness}\n')
    record = ROOT / "data" / "el-centro-1940-ns.csv"
    for axis in ("excitation", "excitation.y"):
        text.append(f'[{axis}]\nkind = "record"\nfile = "{record}"\nunit = "g"\n')
    text.append("[analysis]\nduration = 5.0\nlimits = { memory = 8000 }\n")
    return "".join(text)


def spent(command):
    """Seconds of processors, largest memory [MB] and seconds on the clock of a command."""
    began = time.monotonic()
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit status {process.returncode}")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1000, time.monotonic() - began


def main():
    """Prints the table."""
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program, counts = sys.argv[1], [int(n) for n in sys.argv[2:]] or [100, 200, 500, 1000]
    print("| houses | check [s] | run [s] | a house [ms] | waited [s] | memory [MB] | run -o [s] | memory [MB] |")
    print("| -----: | --------: | ------: | -----------: | ---------: | ----------: | ---------: | ----------: |")
    for houses in counts:
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "block.toml"
            file.write_text(case(houses), encoding="utf-8")
            read, _, _ = spent([program, "check", str(file)])
            run, memory, waited = spent([program, "run", str(file)])
            written, more, _ = spent([program, "run", str(file), "-o", str(pathlib.Path(folder) / "results")])
        print(f"| {houses:,} | {read:.1f} | {run:.1f} | {1000 * run / houses:.0f} | {waited:.1f} | {memory:.0f} | {written:.1f} "
              f"| {more:.0f} |", flush=True)


if __name__ == "__main__":
    main()
