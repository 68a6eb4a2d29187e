"""The version of a wheel and of a source distribution: what the program in it says (cmake/version.cmake).

For scikit-build-core, which pyproject.toml tells of it: https://scikit-build-core.readthedocs.io, "Dynamic metadata".
"""

import pathlib
import shutil
import subprocess

SCRIPT = pathlib.Path(__file__).resolve().parents[1] / "cmake" / "version.cmake"


def dynamic_metadata(settings, project):
    asked = subprocess.run(["cmake", "-P", str(SCRIPT)], check=True, capture_output=True, text=True)
    return {"version": asked.stdout.strip()}


def get_requires_for_dynamic_metadata(settings):
    return [] if shutil.which("cmake") else ["cmake>=3.25"]
