#!/usr/bin/env bash
# run.sh core|units|page: builds that part of the studio and tests it; 77 where something for it is missing.
set -eu
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
here=$root/web/test
export BENTUR_WASM=$root/build/web/bentur_web.mjs
"$root/web/build.sh" "$1"
case $1 in
  core) node --test "$here/core.test.mjs" ;;
  units)
    # Files are those of the machine, through node. What emscripten does not have is pipes and devices: it makes plain files.
    left_out='-InputFile.FoldersPipesAndDevicesAreRefusedAtOnce'
    # Each in two halves at once, of which nothing is heard but what failed and how many there were.
    failed=0
    for program in "$root"/build/web/bentur/src/bentur/*/*_test.js; do
      echo "== $(basename "$program" .js)"
      halves=()
      for half in 0 1; do
        GTEST_TOTAL_SHARDS=2 GTEST_SHARD_INDEX=$half node "$program" --gtest_brief=1 --gtest_filter="$left_out" >"${program%.js}.$half.log" 2>&1 &
        halves+=($!)
      done
      for half in 0 1; do
        wait "${halves[half]}" || failed=1
        cat "${program%.js}.$half.log"
      done
    done
    exit $failed
    ;;
  page)
    command -v chromium >/dev/null || { echo "skipped: chromium is not installed"; exit 77; }
    BENTUR_PAGE=$root/build/web/bentur-studio.html node --test "$here/page.test.mjs" "$here/doors.test.mjs"
    ;;
esac
