#!/usr/bin/env bash
# run.sh build MODULE...: builds the studio and unit tests of modules.
# run.sh core|page: tests that part of it, of the page every thirtieth test (BENTUR_PART=all: all).
# run.sh units MODULE...: runs those tests. 77 where something for it is missing.
set -eu
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
here=$root/web/test
export BENTUR_WASM=$root/build/web/bentur_web.mjs
part=$1
shift
built() { [ -e "$1" ] || { echo "skipped: ${1#"$root/"} has not been built"; exit 77; }; }
case $part in
  build)
    "$root/web/build.sh" units "${@/%/_test}"
    "$root/web/build.sh" page
    ;;
  core)
    built "$BENTUR_WASM"
    export BENTUR_REFUSED=$root/build/web/bad_input
    python3 "$root/tests/bad_input/expand.py" "$root/tests/bad_input" "$BENTUR_REFUSED"
    node --test "$here/core.test.mjs"
    ;;
  units)
    # Files are those of the machine, through node. What emscripten does not have is pipes and devices (it makes plain files),
    # hard links, locks, processes, and the permissions that new files usually have.
    left_out='-InputFile.FoldersPipesAndDevicesAreRefusedAtOnce:OutputRulesTest.InputsAreKnownUnderEveryName:'
    left_out+='AtomicFilesTest.NewFilesHaveTheUsualPermissions:AtomicFilesTest.WhatKilled*:JournalFile.HasOneWriter'
    # Two at a time, each heard when it is done.
    built "$BENTUR_WASM"
    cd "$root/build/web/bentur/src/bentur"
    for module in "$@"; do echo "$module/${module}_test.js"; done | xargs -n 1 -P 2 bash -c '
      said=$(node "$1" --gtest_brief=1 --gtest_filter="$0" 2>&1); status=$?
      printf "== %s\n%s\n" "$(basename "$1" .js)" "$said"; exit $status' "$left_out"
    ;;
  page)
    command -v chromium >/dev/null || { echo "skipped: chromium is not installed"; exit 77; }
    export BENTUR_PAGE=$root/build/web/bentur-studio.html
    built "$BENTUR_PAGE"
    node --test "$here/page.test.mjs" "$here/plan.test.mjs" "$here/suite.test.mjs" "$here/doors.test.mjs"
    ;;
esac
