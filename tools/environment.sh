# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the scripts beside it, which set $root to the project's folder.

cd "$root" || exit 1

# ccache and fontconfig want a cache; without a home that can be written to, it lies in the build folder.
if [ ! -d "${HOME:-}" ] || [ ! -w "${HOME:-}" ]; then
  XDG_CACHE_HOME=${XDG_CACHE_HOME:-$root/build/cache}
  export XDG_CACHE_HOME
fi

# configure_and_build PRESET [CMAKE_BUILD_ARGUMENT...]
configure_and_build() {
  preset=$1
  shift
  cmake --preset "$preset" >build/configure.log 2>&1 || { cat build/configure.log >&2; return 1; }
  cmake --build --preset "$preset" "$@"
}

mkdir -p build
