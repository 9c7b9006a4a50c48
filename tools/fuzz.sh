#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the fuzz targets with clang and runs each for a minute, one after the other; ends at the first finding.
#
#   tools/fuzz.sh                      all of them, a minute each
#   tools/fuzz.sh SECONDS [TARGET...]  csv geojson job kml plan planfile shapefile wkb
#
# What is found new stays in build/fuzz/corpus and is gone on from; an input that fails is left in build/fuzz/found.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
"$root/tools/install-deps.sh" --fuzz
. "$root/tools/environment.sh"

seconds=${1:-60}
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- csv geojson job kml plan planfile shapefile wkb
configure_and_build fuzz >build/fuzz.log 2>&1 || { cat build/fuzz.log >&2; exit 1; }

mkdir -p build/fuzz/found
for target; do
  mkdir -p "build/fuzz/corpus/$target"
  log=build/fuzz/$target.log
  if ! "build/fuzz/bin/fuzz_$target" -max_total_time="$seconds" -timeout=60 -rss_limit_mb=4096 -max_len=8192 \
    -artifact_prefix="build/fuzz/found/$target-" "build/fuzz/corpus/$target" "tests/fuzz/corpus/$target" >"$log" 2>&1; then
    cat "$log" >&2
    echo "fuzz: $target failed on the input named above; run build/fuzz/bin/fuzz_$target INPUT to see it again" >&2
    exit 1
  fi
  echo "fuzz: $target: $(sed -n 's/^Done \([0-9]*\) runs in \([0-9]*\) second.*/\1 runs in \2 s, nothing found/p' "$log")"
done
