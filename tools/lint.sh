#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks format, layers, headers and clang-tidy's rules; changes nothing. --quick leaves clang-tidy out.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
"$root/tools/install-deps.sh" --test --lint
. "$root/tools/environment.sh"
status=0

unformatted=$(find src include tests bench \( -name '*.cpp' -o -name '*.hpp' \) 2>/dev/null | sort |
  xargs clang-format --dry-run -Werror 2>&1 | sed -n 's/:[0-9]*:[0-9]*: error: code should.*//p' | uniq)
if [ -n "$unformatted" ]; then
  echo "lint: not formatted as .clang-format says; make format mends" $unformatted >&2
  status=1
fi

python3 tools/check_layers.py --self-test || status=1
python3 tools/check_layers.py || status=1

configure_and_build dev --target all_verify_interface_header_sets >build/headers.log 2>&1 || {
  cat build/headers.log >&2
  status=1
}
[ "${1:-}" = --quick ] || python3 tools/tidy.py build/dev >&2 || status=1
[ "$status" -ne 0 ] || echo "lint: nothing to mend"
exit "$status"
