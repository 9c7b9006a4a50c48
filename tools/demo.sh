#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds selion and plans a field; needs nothing but a shell.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
"$root/tools/install-deps.sh"
. "$root/tools/environment.sh"

field=data/fields/f1.geojson
out=outputs/f1

configure_and_build release
build/release/bin/selion plan "$field" -o "$out" --overwrite

for file in map.pdf map.svg plan.geojson report.json; do
  [ -s "$out/$file" ] || { echo "demo: $out/$file is missing or empty" >&2; exit 1; }
done
cat <<END

Planned $field with selion's default machine.
  the map to print    $root/$out/map.pdf (the same as a picture: map.svg)
  the paths to drive  $root/$out/plan.geojson (opens in any GIS; docs/plan.md says what is in it)
  the figures         $root/$out/report.json
Your own field: $root/build/release/bin/selion plan FIELD -o DIR
END
