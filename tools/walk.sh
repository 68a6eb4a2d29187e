#!/usr/bin/env bash
# walk.sh ROOT: from nothing to the first own case by the command line, as docs/start.md has it: ./dev run, then the
# commands of the page one after the other, with its case saved where it says. The last line says how long it took.
set -euo pipefail
root=$1
seconds() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.1f", b - a }'; }
now() { date +%s.%N; }
begin=$(now)
"$root/dev" run
first=$(now)
PATH=$root/build/release/apps/bentur:$PATH
work=$(mktemp -d)
cd "$work"
page=$root/docs/start.md
mkdir -p mine
awk '/^```toml$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$page" >mine/own.toml
awk '/^```sh$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$page" >commands.sh
bash -euo pipefail commands.sh
own=$(now)
[ -s report.html ]
rm -rf "$work"
echo "1 passed, 0 failed"
echo "first case after $(seconds "$begin" "$first") s, first own case after $(seconds "$begin" "$own") s"
