# SPDX-License-Identifier: GPL-3.0-or-later
# Flags of our own targets; docs/building.md says why each is there.
function(selion_flags target)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -fno-math-errno -fno-trapping-math -flto=auto -ffat-lto-objects)
    target_link_options(${target} PRIVATE -flto=auto -Werror=odr)
  endif()
  if(SELION_STRICT)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
  endif()
  if(SELION_SANITIZE)
    set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    # GCC 12 warns of std::regex's own code once it is sanitized (GCC bug 105562).
    target_compile_options(${target} PRIVATE ${sanitizers} $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_link_options(${target} PRIVATE ${sanitizers})
  endif()
endfunction()
