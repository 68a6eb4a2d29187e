#!/usr/bin/env bash
# check_tool.sh format|tidy PROGRAM SOURCE_DIR BUILD_DIR: clang-format over all sources, clang-tidy over a hundred-and-twentieth of them
# (tests/part.py), one warning fails.
# Other versions than 14 format and warn differently; with those the check is skipped (status 77).
set -euo pipefail
check=$1 program=$2 source=$3 build=$4
version=$("$program" --version 2>/dev/null | sed -n 's/.*version \([0-9]*\)\..*/\1/p' | head -n 1) || true
if [ "$version" != 14 ]; then
  echo "skipped: clang-$check 14 is not installed"
  exit 77
fi
cd "$source"
folders=()
for folder in src apps tests bench bindings; do [ ! -d $folder ] || folders+=($folder); done
case $check in
  format) find "${folders[@]}" \( -name '*.h' -o -name '*.cpp' \) -print0 | xargs -0 "$program" --dry-run -Werror ;;
  tidy)
    # Tests are left out: GoogleTest's macros do not follow the checks. Clang does not know all of g++'s warnings.
    # Many sources at a time, in a unity build of its own: most of the time goes into the libraries' headers.
    cmake -S . -B "$build/tidy" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
      -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=8 -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON \
      -DBENTUR_BUILD_TESTS=OFF -DBENTUR_BUILD_BENCH=OFF -DBENTUR_HOUSE_CHECKS=OFF >"$build/tidy.log"
    # Generated sources are not there yet.
    sed -n 's/^  "file": "\(.*\)".*$/\1/p' "$build/tidy/compile_commands.json" | python3 tests/part.py 120 |
      while read -r file; do [ ! -f "$file" ] || printf '%s\0' "$file"; done |
      xargs -0 -n 1 -P "$(nproc)" "$program" -p "$build/tidy" --config-file=.clang-tidy --checks=-bugprone-suspicious-include \
        --quiet --warnings-as-errors='*' --extra-arg=-Wno-unknown-warning-option 2>&1 | sed '/^[0-9]* warnings generated\.$/d' ;;
esac
