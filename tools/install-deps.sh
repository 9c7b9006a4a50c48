#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the Debian packages that are missing, and only those.
#
#   tools/install-deps.sh            what building and running selion needs
#   tools/install-deps.sh --test     and what its tests need
#   tools/install-deps.sh --lint     and what the linters need
#   tools/install-deps.sh --bench    and what the benchmarks need
#   tools/install-deps.sh --fuzz     and what the fuzz targets need
#   --print                          only name the missing packages
set -eu

wanted='g++ cmake ninja-build pkg-config ccache
  libgdal-dev libproj-dev proj-data libpolyclipping-dev libgeos-dev
  nlohmann-json3-dev libcli11-dev libtomlplusplus-dev
  libcairo2-dev libpango1.0-dev fonts-dejavu-core libtbb-dev'
print_only=
for option; do
  case $option in
    --test) wanted="$wanted catch2 libpugixml-dev poppler-utils python3" ;;
    --lint) wanted="$wanted clang-format clang-tidy clang-tools python3" ;;
    --bench) wanted="$wanted libbenchmark-dev" ;;
    --fuzz) wanted="$wanted clang libclang-rt-dev" ;;
    --print) print_only=yes ;;
    *)
      sed -n '3,10s/^# \{0,1\}//p' "$0" >&2
      exit 2
      ;;
  esac
done

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "install-deps: this is no Debian system; install the counterparts of these packages by hand:" $wanted >&2
  exit 1
fi
missing=
for package in $wanted; do
  is_installed "$package" || missing="$missing $package"
done
if [ -z "$missing" ] || [ -n "$print_only" ]; then
  [ -z "$missing" ] || echo "${missing# }"
  exit 0
fi

if [ "$(id -u)" -eq 0 ]; then
  as_root=env
elif command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [ -t 0 ]; }; then
  as_root='sudo env'
else
  echo "install-deps: packages are missing and this user may not install them; as root run" >&2
  echo "  apt-get install --no-install-recommends$missing" >&2
  exit 1
fi

echo "install-deps: installing$missing (a minute or two, about 1 GB on a bare machine)" >&2
apt() { $as_root DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -qq -o Dpkg::Use-Pty=0 "$@" >/dev/null; }
if ! apt update || ! apt install --yes --no-install-recommends $missing; then
  echo "install-deps: apt-get failed; look at its message above, at the network and at /etc/apt/sources.list" >&2
  exit 1
fi
