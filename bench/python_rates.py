#!/usr/bin/env python3
"""What studies and single runs take from Python, everything in one run, the alternatives taking turns.

    PYTHONPATH=build/release/bindings/python python3 bench/python_rates.py [--rows N] [--turns N] [--only WORD]

- rows: the same N rows of gap, damping and stiffness (10,000 by default) as cases of `run_many`, as rows of `vary` and
  as a study of `sweep`, one thread each: runs a second of a processor, and how many times that of `sweep`;
- threads: what two threads are worth to each by the clock on the wall, which needs two processors with nothing else to
  do; so beside them two processes, which share no lock and wait for nothing but the machine;
- run: milliseconds of a processor of `bentur.run` of the built-in example, and of its histories when first asked for;
- law: times of a contact law of compiled functions and of the same law built in, and their ratio.

Ratios are of turns next to each other, and their median is given.
"""

import argparse
import ctypes
import multiprocessing
import statistics
import subprocess
import sys
import tempfile
import time
import warnings
from pathlib import Path

import numpy as np

import bentur

KEYS = ("gap[0].width", "building[0].damping", "building[1].damping")


def rows_of(count):
    """The values of a design, by their keys."""
    random = np.random.default_rng(57)
    return {KEYS[0]: random.uniform(0.1, 0.8, count).tolist(), KEYS[1]: random.uniform(0.03, 0.07, count).tolist(),
            KEYS[2]: random.uniform(0.03, 0.07, count).tolist()}


def study_file(folder, case, rows):
    """The same rows as a study."""
    case.save(folder / "case.toml")
    text = 'case = "case.toml"\n'
    for n, (key, values) in enumerate(rows.items()):
        text += f'[[vary]]\nparameter = {key!r}\nname = "value{n}"\nvalues = {values}\ntogether = "row"\n'
    (folder / "study.toml").write_text(text, encoding="utf-8")
    return folder / "study.toml"


def spent(work):
    """Seconds of a processor, of all threads, and on the clock on the wall."""
    wall, processor = time.perf_counter(), time.process_time()
    work()
    return time.process_time() - processor, time.perf_counter() - wall


def ways(count, folder):
    """Each way of running the same rows, on so many threads."""
    case = bentur.example()
    rows = rows_of(count)

    def made():
        return [case.replace(dict(zip(rows, one, strict=True))) for one in zip(*rows.values(), strict=True)]

    cases = made()
    study = study_file(folder, case, rows)
    return {"sweep": lambda threads: bentur.sweep(study, threads=threads),
            "vary": lambda threads: bentur.vary(case, rows, together=True, threads=threads),
            "run_many": lambda threads: bentur.run_many(cases, keep_cases=False, threads=threads),
            "run_many, its cases made too": lambda threads: bentur.run_many(made(), keep_cases=False, threads=threads)}


def rows(count, turns, folder):
    """Rates of the ways on one thread."""
    tried = ways(count, folder)
    seconds = {name: [] for name in tried}
    for turn in range(turns):
        for name in sorted(tried, reverse=turn % 2 == 1):
            seconds[name].append(spent(lambda run=tried[name]: run(1))[0])
    print(f"| {count:,} rows, one thread | runs/s of a processor | to sweep |\n| :-- | --: | --: |")
    for name in tried:
        ratio = statistics.median(s / own for s, own in zip(seconds["sweep"], seconds[name], strict=True))
        print(f"| {name} | {count / min(seconds[name]):.0f} | {ratio:.2f} |", flush=True)


def beside_each_other(run):
    """Seconds on the clock on the wall of two processes that each do the work, on one thread: what two threads that
    never wait for one another take for twice the work, on this machine at this moment."""
    fork = multiprocessing.get_context("fork")
    processes = [fork.Process(target=run, args=(1,)) for _ in range(2)]
    start = time.perf_counter()
    for one in processes:
        one.start()
    for one in processes:
        one.join()
        if one.exitcode != 0:
            sys.exit(f"a process ended with {one.exitcode}")
    return time.perf_counter() - start


def threads(count, turns, folder):
    """What two threads are worth."""
    print("| two threads | wall: times one | best | two processes | threads to processes | processor time to one | "
          "of it by one thread alone |\n| :-- | --: | --: | --: | --: | --: | --: |")
    for name, run in ways(count, folder).items():
        wall, processes, processor, alone = [], [], [], []
        for _ in range(turns):
            one, begun = spent(lambda run=run: run(1)), time.thread_time()
            two = spent(lambda run=run: run(2))
            alone.append((time.thread_time() - begun) / two[0])  # this thread runs nothing itself
            wall.append(one[1] / two[1])
            processes.append(2 * one[1] / beside_each_other(run))
            processor.append(two[0] / one[0])
        ratio = statistics.median(a / b for a, b in zip(wall, processes, strict=True))
        print(f"| {name} | {statistics.median(wall):.2f} | {max(wall):.2f} | {statistics.median(processes):.2f} | "
              f"{ratio:.2f} | {statistics.median(processor):.2f} | {100 * statistics.median(alone):.0f} % |", flush=True)


def run_alone(turns):
    """A single run, and its histories."""
    case = bentur.example()
    bentur.run(case)
    runs, histories = [], []
    for _ in range(20 * turns):
        made = []
        runs.append(spent(lambda made=made: made.append(bentur.run(case)))[0])
        histories.append(spent(lambda made=made: made[0].histories)[0])
    print("| bentur.run of the example | least [ms] | median [ms] |\n| :-- | --: | --: |")
    for name, times in (("run", runs), ("its histories", histories)):
        print(f"| {name} | {1e3 * min(times):.2f} | {1e3 * statistics.median(times):.2f} |", flush=True)


SOURCE = """
#include <math.h>
double force(double d, double v) { (void)v; return d > 0 ? %r * d * sqrt(d) : 0; }
double energy(double d) { return d > 0 ? 0.4 * %r * d * d * sqrt(d) : 0; }
"""


def compiled(stiffness, folder):
    """A force k δ^1.5 and its energy, compiled by the machine's own compiler."""
    source, library = folder / "law.c", folder / "law.so"
    source.write_text(SOURCE % (stiffness, stiffness), encoding="utf-8")
    subprocess.run(["cc", "-O2", "-shared", "-fPIC", str(source), "-o", str(library), "-lm"], check=True)
    made = ctypes.CDLL(str(library))
    for function, arguments in ((made.force, 2), (made.energy, 1)):
        function.argtypes, function.restype = [ctypes.c_double] * arguments, ctypes.c_double
    return bentur.ForceLaw(force=made.force, energy=made.energy)


def law(turns, folder):
    """A law by compiled functions, and the built-in one."""
    stiffness = 2e6
    case = bentur.example()
    laws = {"hertz": case.replace({"gap[0].contact": {"law": "hertz", "stiffness": stiffness}}),
            "compiled": case.replace({"gap[0].contact": compiled(stiffness, folder)})}
    seconds = {name: [] for name in laws}
    for turn in range(10 * turns):
        for name in sorted(laws, reverse=turn % 2 == 1):
            seconds[name].append(spent(lambda one=laws[name]: bentur.run(one))[0])
    ratio = statistics.median(b / a for a, b in zip(seconds["hertz"], seconds["compiled"], strict=True))
    print("| law k δ^1.5 | median [ms] | to built in |\n| :-- | --: | --: |")
    print(f"| built in | {1e3 * statistics.median(seconds['hertz']):.2f} | 1 |")
    print(f"| compiled functions | {1e3 * statistics.median(seconds['compiled']):.2f} | {ratio:.2f} |", flush=True)


def main():
    """Prints the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", type=int, default=10000)
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--only", choices=["rows", "threads", "run", "law"])
    asked = parser.parse_args()
    warnings.simplefilter("ignore", bentur.RemarkWarning)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for part, measure in (("rows", lambda: rows(asked.rows, asked.turns, folder)),
                              ("threads", lambda: threads(asked.rows, asked.turns, folder)),
                              ("run", lambda: run_alone(asked.turns)), ("law", lambda: law(asked.turns, folder))):
            if asked.only in (None, part):
                measure()
                print(flush=True)


if __name__ == "__main__":
    main()
