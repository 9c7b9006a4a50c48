#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds the benchmarks with the flags of release and runs them.
#
#   tools/bench.sh                   prints the table of docs/performance.md
#   tools/bench.sh ARGUMENT...       Google Benchmark, for example --benchmark_filter=plan_field/f1
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
"$root/tools/install-deps.sh" --bench
. "$root/tools/environment.sh"
configure_and_build bench
build/bench/bin/selion_bench "$@"
