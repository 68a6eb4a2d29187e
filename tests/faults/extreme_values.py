#!/usr/bin/env python3
"""Extreme values of every key through `bentur check` and `bentur run`.

    BENTUR=... BENTUR_SOURCE=... extreme_values.py [--cases N] [--seed S] [--keep DIR] [--only K]

Case K of a seed is always the same: an example with one to three of its numbers replaced. The program must end by itself
with a status it documents, within 10 s of processor time unless it said beforehand that it may take longer, within
1 GiB, and a failure must say why. --keep writes the cases that do not into a folder.
"""
import argparse
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile

BENTUR = os.environ["BENTUR"]
SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"])
VALUES = [0, -1, 1e308, -1e308, 5e-324, 1e-308, 1e-300, 1e300, 1e-100, 1e100, 1e-30, 1e30, 1e-20, 1e20, 1e-15, 1e15, 1e-9,
          1e9, 1e-6, 1e6, 1e-3, 1e3, 0.1, 10, 0.5, 2, 1.7976931348623157e308, 2.4703282292062327e-324]
NAMES = ["m12-el-centro", "kelvin-voigt-pair", "m12-harmonic", "m12-runge-kutta", "restitution-asked", "row-of-three",
         "two-frames-si", "free-impact"]
NUMBER = re.compile(r"(?<![\w.\"-])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w\"])")
MEMORY = 1 << 30  # bytes
ADDRESSES = 3 << 29  # bytes that may be reserved
SECONDS = 10


def numbers_of(text):
    """Places of the numbers outside of texts and comments."""
    found = []
    start = 0
    for line in text.splitlines(keepends=True):
        bare = re.sub(r'"[^"]*"', lambda match: '"' + "_" * (len(match[0]) - 2) + '"', line)
        bare = bare.split("#")[0]
        found += [(start + match.start(), start + match.end()) for match in NUMBER.finditer(bare)]
        start += len(line)
    return found


def mutated(text, rng):
    """The text with one to three numbers replaced, sometimes with a key more, or short as a run."""
    if rng.random() < 0.3:
        text = re.sub(r"(\ndamping = )", "\ncalibrate_period = 0.3\\1", text, count=rng.choice([1, 2]))
    if rng.random() < 0.2:
        law = rng.choice(['"hertz", stiffness = 1e6', '"jankowski", stiffness = 1e6, restitution = 0.6',
                          '"kelvin-voigt", stiffness = 1e6, restitution = 0.6, release = "creep"',
                          '"bilinear", stiffness = 1e6, second_stiffness = 1e5, yield_penetration = 0.1',
                          '"filler", crushing_force = 100, thickness = 0.1, crushing_strain = 0.02, '
                          'locking_strain = 0.6, locked_stiffness = 1e6',
                          '"restitution", restitution = 0.6', '"darmawan", stiffness = 1e6, alpha = 1.0'])
        text = re.sub(r'contact = \{ law = .*\}', "contact = { law = " + law + " }", text)
    if rng.random() < 0.2:
        text = re.sub(r"\[analysis\]", "[analysis]\n" + rng.choice(
            ["output_step = 0.01", "energy_audit = true", "limits = { steps = 1e6, memory = 100 }"]), text)
        if text.count("energy_audit") > 1 or text.count("output_step") > 1:
            text = text.replace("[analysis]\nenergy_audit = true", "[analysis]").replace(
                "[analysis]\noutput_step = 0.01", "[analysis]")
    for _ in range(rng.choice([1, 1, 1, 2, 3])):
        begin, end = rng.choice(numbers_of(text))
        value = rng.choice(VALUES)
        text = text[:begin] + (repr(value) if rng.random() < 0.7 else repr(-value * rng.random())) + text[end:]
    return text


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (ADDRESSES, ADDRESSES))
    resource.setrlimit(resource.RLIMIT_CPU, (600, 600))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def trouble(arguments):
    """What is wrong with how the program took it, or nothing."""
    with tempfile.TemporaryFile("w+") as messages:
        process = subprocess.Popen([BENTUR, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=messages,
                                   preexec_fn=limit)
        _, status, usage = os.wait4(process.pid, 0)
        code = process.returncode = os.waitstatus_to_exitcode(status)
        messages.seek(0)
        said = messages.read()
    spent = usage.ru_utime
    if code < 0:
        return f"ended by signal {-code} after {spent:.1f} s"
    if code not in (0, 2, 3):
        return f"status {code}: {said[-300:]}"
    if code != 0 and not said.strip():
        return f"status {code} and not a word"
    if "memory of this machine" in said or usage.ru_maxrss << 10 > MEMORY:
        return f"{usage.ru_maxrss >> 10} MiB of memory"
    if spent > SECONDS and "may take up to" not in said:
        return f"{spent:.1f} s, of which nothing was said: {said[-300:]}"
    return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cases", type=int, default=200)
    parser.add_argument("--seed", type=int, default=20261122)
    parser.add_argument("--only", type=int)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    wrong = 0
    with tempfile.TemporaryDirectory(prefix="bentur-extremes-") as scratch:
        scratch = pathlib.Path(scratch)
        texts = []
        for name in NAMES:
            subprocess.run([BENTUR, "example", name, "-o", scratch], check=True, capture_output=True)
            texts.append((scratch / f"{name}.toml").read_text())
        for number in [options.only] if options.only is not None else range(options.cases):
            rng = random.Random(options.seed * 1000003 + number)
            text = mutated(rng.choice(texts), rng)
            case = scratch / "case.toml"
            case.write_text(text)
            results = scratch / "results"
            commands = [["check", case], ["run", case] if number % 2 else ["run", case, "-o", results]]
            for command in commands:
                found = trouble(command)
                if found is None:
                    continue
                wrong += 1
                print(f"case {number}, bentur {command[0]}: {found}", flush=True)
                if options.keep:
                    options.keep.mkdir(parents=True, exist_ok=True)
                    shutil.copy(case, options.keep / f"{number}.toml")
                break
            shutil.rmtree(results, ignore_errors=True)
    print(f"{wrong} of {options.cases} cases went wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
