#!/usr/bin/env bash
# newcomer.sh FOLDER: on a machine with python3-venv and nothing else: the wheel of FOLDER for this Python, the first case
# and the first own case as docs/start.md has them, then, with what they import from PyPI, every example of
# examples/python. The last lines say how long each took, by the clock.
set -euo pipefail
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
seconds() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.1f", b - a }'; }
now() { date +%s.%N; }

! command -v cc c++ gcc g++ || { echo "there is a compiler here"; exit 1; }
begin=$(now)
python3 -m venv ~/first
~/first/bin/pip install --disable-pip-version-check --quiet --find-links "$1" --only-binary :all: bentur
installed=$(now)
mkdir -p ~/work
cd ~/work
# The blocks of the page: the first case, the first own case.
awk '/^```python$/ { inside = 1; file = "block-" ++count ".py"; next } /^```$/ { inside = 0 } inside { print > file }' \
  "$source/docs/start.md"
~/first/bin/python block-1.py
first=$(now)
~/first/bin/python block-2.py | tee own.txt
own=$(now)
grep -q '^Office | House: pounding, ' own.txt
passed=2
~/first/bin/pip install --disable-pip-version-check --quiet --find-links "$1" --only-binary :all: 'bentur[all]' scipy
all=$(now)
export MPLBACKEND=Agg
for example in "$source"/examples/python/*.py; do
  if grep -q openseespy "$example" && ! ~/first/bin/python -c 'import openseespy' 2>/dev/null; then
    echo "$(basename "$example"): left out, openseespy is not installed"
    continue
  fi
  ~/first/bin/python "$example" >"$(basename "$example" .py).txt" 2>&1 || { cat "$(basename "$example" .py).txt"; exit 1; }
  passed=$((passed + 1))
done
echo "$passed passed, 0 failed"
echo "package installed after $(seconds "$begin" "$installed") s, first case after $(seconds "$begin" "$first") s," \
  "first own case after $(seconds "$begin" "$own") s"
echo "what the examples import: $(seconds "$own" "$all") s; $((passed - 2)) examples: $(seconds "$all" "$(now)") s"
