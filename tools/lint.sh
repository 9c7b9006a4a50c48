#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks formatting, layers, headers and clang-tidy's rules; changes nothing.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
"$root/tools/install-deps.sh" --test --lint
. "$root/tools/environment.sh"

find src include tests bench -name '*.cpp' -o -name '*.hpp' 2>/dev/null | sort | xargs clang-format --dry-run -Werror
python3 tools/check_layers.py --self-test
python3 tools/check_layers.py
configure_and_build dev --target all_verify_interface_header_sets
run-clang-tidy -quiet -p build/dev -j "$(nproc)" "$root/src/" >build/tidy.log 2>build/tidy.errors || {
  grep -E '(warning|error):' build/tidy.log | sort -u >&2
  cat build/tidy.errors >&2
  exit 1
}
echo "lint: nothing to mend"
