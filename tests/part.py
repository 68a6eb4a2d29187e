"""The part of a long list of checks that every run makes: each OF-th by name, the same for every commit.

With BENTUR_PART=all in the environment no check is left out, as ./dev soak has it.

    part.py OF < list
"""

import os
import sys
import unittest


def part(checks, of):
    """Every OF-th of the sorted `checks`, all of them with BENTUR_PART=all."""
    return sorted(checks)[:: 1 if os.environ.get("BENTUR_PART") == "all" else of]


def part_of_tests(tests, of):
    """The part of a suite as unittest loads it, for load_tests of a module."""
    by_name = {test.id(): test for cases in tests for test in cases}
    return unittest.TestSuite(by_name[name] for name in part(by_name, of))


def part_under_sanitizers(tests, of):
    """All tests of a suite; where every start of the program takes long (BENTUR_SANITIZED=1) every OF-th of them."""
    return part_of_tests(tests, of) if os.environ.get("BENTUR_SANITIZED") == "1" else tests


if __name__ == "__main__":
    print("\n".join(part(sys.stdin.read().splitlines(), int(sys.argv[1]))))
