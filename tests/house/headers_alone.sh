#!/usr/bin/env bash
# headers_alone.sh SOURCE_DIR BUILD_DIR: compiles a hundred-and-sixtieth of the installed headers (tests/part.py), each by itself.
set -euo pipefail
ninja -C "$2" -t targets all | sed -n 's/^\(.*_verify_interface_header_sets.*\.o\): .*/\1/p' |
  python3 "$1/tests/part.py" 160 | xargs cmake --build "$2" --target
