"""Where the refused cases of tests/bad_input are, one file each."""

import functools
import pathlib
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).parent / "bad_input"
_kept = []


@functools.cache
def refused():
    """The folder, written once a process."""
    _kept.append(tempfile.TemporaryDirectory(prefix="bentur-refused-"))
    folder = pathlib.Path(_kept[-1].name)
    subprocess.run([sys.executable, SOURCE / "expand.py", SOURCE, folder], check=True)
    return folder
