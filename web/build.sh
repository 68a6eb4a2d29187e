#!/usr/bin/env bash
# What ./dev studio and the tests build into build/web: build.sh core|page|units TEST...
#   core   bentur_web.mjs, the library as a module
#   units  unit tests as programs for node, those that are named: core_test io_test ...
#   page   bentur-studio.html, the core and the page in one file
# Exit status 77, saying so, where a tool is missing.
set -eu
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$root/build/web
jobs=${BENTUR_JOBS:-$(nproc)}

need() {
  local tool
  for tool in "$@"; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed (./dev studio installs it)"; exit 77; }
  done
}

core() {
  need emcc node cmake ninja
  # emscripten's own scripts for node are where Debian puts them, also beside a node from elsewhere.
  export NODE_PATH=/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}
  local options=()
  if command -v ccache >/dev/null; then
    # With ccache told what em++ is, and to look at its sources after the preprocessor.
    options=(-DCMAKE_CXX_COMPILER_LAUNCHER="env;CCACHE_COMPILERTYPE=clang;CCACHE_SLOPPINESS=pch_defines,time_macros;ccache")
  fi
  emcmake cmake -S "$root/web/wasm" -B "$out" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG" \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 -DBENTUR_WEB_TESTS=ON -DCMAKE_CROSSCOMPILING_EMULATOR="$(command -v node)" \
    "${options[@]}" >"$out.log" 2>&1 || { cat "$out.log"; exit 1; }
  cmake --build "$out" --parallel "$jobs" --target "$@"
}

page() {
  need npm
  if ! node -e 'const [a, b] = process.versions.node.split(".").map(Number); process.exit(a > 20 || (a === 20 && b >= 19) ? 0 : 1)'; then
    echo "skipped: the page is put together by vite, which needs node 20.19 or newer, and here is $(node --version)"
    exit 77
  fi
  if ! cmp -s "$root/web/package-lock.json" "$root/web/node_modules/.bentur-lock"; then
    (cd "$root/web" && npm ci --no-fund --no-audit >"$out/npm.log" 2>&1) || {
      cat "$out/npm.log"
      echo "skipped: npm cannot install what the page is made of; is there a network?"
      exit 77
    }
    cp "$root/web/package-lock.json" "$root/web/node_modules/.bentur-lock"
  fi
  (cd "$root/web" && npm run --silent build)
  cp "$out/page/index.html" "$out/bentur-studio.html"
}

mkdir -p "$out"
case ${1:-page} in
  core) core bentur_web ;;
  units) core "${@:2}" ;;
  page) core bentur_web; page ;;
  *) echo "build.sh knows core, units and page"; exit 1 ;;
esac
