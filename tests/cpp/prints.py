"""prints.py FILE PROGRAM: PROGRAM, given the case in CASE if there is one, prints what is in FILE."""

import os
import pathlib
import subprocess
import sys

file, program = sys.argv[1:]
arguments = [os.environ["CASE"]] if "CASE" in os.environ else []
shown = subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout
print(shown, end="")
sys.exit(shown != pathlib.Path(file).read_text())
