#!/usr/bin/env bash
# newcomer.sh FOLDER: on a machine with python3-venv and nothing else: the wheel of FOLDER for this Python, the first case.
# The last line says how long that took.
set -euo pipefail
begin=$(date +%s)
python3 -m venv ~/first
~/first/bin/pip install --disable-pip-version-check --quiet --find-links "$1" --only-binary :all: bentur
installed=$(date +%s)
! command -v cc c++ gcc g++ || { echo "there is a compiler here"; exit 1; }
cd ~
~/first/bin/python -c '
import bentur
result = bentur.run(bentur.example())
print(result)
assert result.impact_count == 37, result.impact_count'
echo "1 passed, 0 failed"
echo "installed in $((installed - begin)) s, first case $(($(date +%s) - begin)) s after nothing"
