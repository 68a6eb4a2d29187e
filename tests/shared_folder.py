"""Records and answers that the project does not ship: `SHARED` is ../shared beside the repository, or the folder that the
environment variable BENTUR_SHARED names. Where it does not exist, as for most users, tests that need it are skipped.
"""

import inspect
import os
import pathlib
import re
import sys
import unittest

SHARED = pathlib.Path(os.environ.get("BENTUR_SHARED", pathlib.Path(__file__).resolve().parents[2] / "shared"))


def main(verbosity=1):
    """Runs the tests of the script; where BENTUR_ALONE is set those alone that name the folder, or the records in it."""
    names = []
    if os.environ.get("BENTUR_ALONE"):
        for case in vars(sys.modules["__main__"]).values():
            if inspect.isclass(case) and issubclass(case, unittest.TestCase) and case.__module__ == "__main__":
                names += [f"{case.__name__}.{name}" for name, test in vars(case).items()
                          if name.startswith("test") and re.search(r"\b(SHARED|RECORDS)\b", inspect.getsource(test))]
        assert names, "no test names the folder"
    unittest.main(argv=[sys.argv[0], *(names or sys.argv[1:])], verbosity=verbosity)
