#!/usr/bin/env bash
# run.sh core|page|units [--part] MODULE...: builds that part of the studio and tests it; --part: one of three modules
# (tests/part.py). 77 where something for it is missing.
set -eu
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
here=$root/web/test
export BENTUR_WASM=$root/build/web/bentur_web.mjs
part=$1
shift
if [ "${1:-}" = --part ]; then
  shift
  mapfile -t modules < <(printf '%s\n' "$@" | python3 "$root/tests/part.py" 3)
  set -- "${modules[@]}"
fi
"$root/web/build.sh" "$part" "${@/%/_test}"
case $part in
  core) node --test "$here/core.test.mjs" ;;
  units)
    # Files are those of the machine, through node. What emscripten does not have is pipes and devices (it makes plain files),
    # hard links, locks, processes, and the permissions that new files usually have.
    left_out='-InputFile.FoldersPipesAndDevicesAreRefusedAtOnce:OutputRulesTest.InputsAreKnownUnderEveryName:'
    left_out+='AtomicFilesTest.NewFilesHaveTheUsualPermissions:AtomicFilesTest.WhatKilled*:JournalFile.HasOneWriter'
    # Two at a time, each heard when it is done.
    cd "$root/build/web/bentur/src/bentur"
    for module in "$@"; do echo "$module/${module}_test.js"; done | xargs -n 1 -P 2 bash -c '
      said=$(node "$1" --gtest_brief=1 --gtest_filter="$0" 2>&1); status=$?
      printf "== %s\n%s\n" "$(basename "$1" .js)" "$said"; exit $status' "$left_out"
    ;;
  page)
    command -v chromium >/dev/null || { echo "skipped: chromium is not installed"; exit 77; }
    BENTUR_PAGE=$root/build/web/bentur-studio.html node --test "$here/page.test.mjs" "$here/doors.test.mjs"
    ;;
esac
