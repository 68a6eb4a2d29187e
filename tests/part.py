"""The part of a long list of checks that one run makes: every OF-th, beginning at another one with each commit.

The environment variable BENTUR_PART tells the beginning instead, or `all`: no check is left out, as ./dev soak has it.

    part.py OF < list
"""

import os
import pathlib
import subprocess
import sys
import unittest


def part(checks, of):
    """Every OF-th of the sorted `checks`, all of them with BENTUR_PART=all."""
    begin = os.environ.get("BENTUR_PART") or commits()
    return sorted(checks) if begin == "all" else sorted(checks)[int(begin) % of :: of]


def part_of_tests(tests, of):
    """The part of a suite as unittest loads it, for load_tests of a module."""
    by_name = {test.id(): test for cases in tests for test in cases}
    return unittest.TestSuite(by_name[name] for name in part(by_name, of))


def commits():
    """How many commits lead here; 0 in a copy without git."""
    counted = subprocess.run(["git", "rev-list", "--count", "HEAD"], capture_output=True, text=True,
                             cwd=pathlib.Path(__file__).parent)
    return counted.stdout.strip() or "0"


if __name__ == "__main__":
    print("\n".join(part(sys.stdin.read().splitlines(), int(sys.argv[1]))))
