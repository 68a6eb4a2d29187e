"""run.py ARGUMENTS: pytest with these arguments; status 77 (skipped) where something is missing that the tests need."""

import importlib.util
import os
import sys

if __name__ == "__main__":  # and not in the processes that a test starts
    missing = [n for n in ("numpy", "pytest", "xarray", "pandas", "netCDF4") if importlib.util.find_spec(n) is None]
    if missing:
        print(f"skipped: without {', '.join(missing)} (Debian: {', '.join('python3-' + m.lower() for m in missing)})")
        sys.exit(77)
    python = os.environ.get("BENTUR_NUMPY_PYTHON", sys.executable)
    if not os.path.exists(python):
        print(f"skipped: {python} is not there: ./dev test --all makes it, where PyPI has that NumPy for this Python")
        sys.exit(77)

    import pytest

    sys.exit(pytest.main(sys.argv[1:]))
