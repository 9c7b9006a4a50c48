#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds selion and its tests and runs them all; needs nothing but a shell.
#
#   tools/test.sh [PRESET]     dev (as told below) or asan; docs/building.md has the flags of each
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
"$root/tools/install-deps.sh" --test
. "$root/tools/environment.sh"

preset=${1:-dev}
log=build/$preset/Testing/Temporary/LastTest.log

python3 tools/check_layers.py --self-test
python3 tools/check_layers.py
python3 tools/make_fields.py --check
configure_and_build "$preset"

started=$(date +%s)
status=0
ctest --preset "$preset" --parallel "$(nproc)" --no-tests=error || status=$?
seconds=$(($(date +%s) - started))

grep -o 'skipped: .*' "$log" | sort -u || true
if [ "$status" -ne 0 ]; then
  echo "test ($preset): FAILED after $seconds s; $root/$log has the whole output" >&2
  exit "$status"
fi
cases=$(sed -n 's/.* in \([0-9]*\) test cases\{0,1\}).*/\1/p' "$log" | awk '{ n += $1 } END { print n + 0 }')
echo "test ($preset): all $cases test cases passed in $seconds s"
