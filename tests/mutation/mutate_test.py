#!/usr/bin/env python3
"""tools/mutate.py on a small program: without a choice it answers as before, and each change answers otherwise."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "tools"))
import mutate  # noqa: E402

PROGRAM = """#include <algorithm>
#include <cstdio>

using namespace bentur;

// if (comments) return 1; are no statements, "nor if (texts) return 2;"
double grown(double x, int count) {
  double sum = 0.5;
  const double factor = x * 2.5;
  for (int i = 0; i < count; ++i) {
    sum += factor;
  }
  if (sum > 100 && count == 7) return std::min(sum, 100.0);
  return sum - x;
}

int main() {
  for (double x : {1.0, 2.0, 7.0}) {
    for (int count : {0, 3, 7}) std::printf("%.17g if (x) return 3; \\n", grown(x, count));
  }
}
"""


class Mutate(unittest.TestCase):
    def test_each_change_is_one_alone(self):
        """Programs that each hold a change of every statement."""
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        sites = list({site[0]: site for site in mutate.sites(PROGRAM)}.values())
        self.assertEqual(len(sites), 6, "both declarations, what is added, the condition, both returns")
        (folder / "mutant.h").write_text(mutate.MUTANT_H)
        (folder / "mutant.cpp").write_text(mutate.MUTANT_CPP % len(sites))
        plain, same = set(), set()
        for i in range(max(len(ways) for _, _, ways in sites)):
            text = PROGRAM
            for number, (begin, end, ways) in reversed(list(enumerate(sites))):
                text = text[:begin] + ways[i % len(ways)][1].replace("{m}", str(number)) + text[end:]
            (folder / "program.cpp").write_text('#include "mutant.h"\n' + text)
            subprocess.run([os.environ.get("CXX", "c++"), "-std=c++20", "program.cpp", "mutant.cpp", "-o", "program"],
                           cwd=folder, check=True)

            def answer(**environment):
                return subprocess.run([folder / "program"], capture_output=True, text=True, check=True,
                                      env=environment).stdout
            plain.add(answer())
            same |= {ways[i % len(ways)][0] for number, (_, _, ways) in enumerate(sites)
                     if answer(BENTUR_MUTANT=str(number)) == answer()}
        self.assertEqual(len(plain), 1, "none is chosen")
        self.assertEqual(same, {"> is >="}, "only what is at the end of a range changes nothing")

    def test_an_assignment_is_left_out_or_turned_round(self):
        ways = [what for _, _, of in mutate.sites("void f() {\n  total += 2 * x;\n}\n") for what, _ in of]
        self.assertEqual(ways, ["2 is 3", "left out", "+= is -="])


if __name__ == "__main__":
    unittest.main()
