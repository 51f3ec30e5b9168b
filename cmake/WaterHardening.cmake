# SPDX-License-Identifier: BSD-3-Clause
# What is shipped is built so that an error in memory ends the program instead of leading it on:
# checked stack frames, checked calls of the C library, relocations that are read-only before main,
# no executable stack. For every configuration with an optimiser, which the checked calls need;
# sanitizers check more than these. See Documentation/security.md.
option(WATER_HARDENED "Build with the compiler's and the linker's protections" ON)

if(WATER_HARDENED AND NOT WATER_SANITIZE AND CMAKE_C_COMPILER_ID MATCHES "GNU|Clang" AND
    CMAKE_SYSTEM_NAME STREQUAL "Linux")
  foreach(config IN ITEMS RELEASE RELWITHDEBINFO MINSIZEREL)
    foreach(language IN ITEMS C CXX)
      string(APPEND CMAKE_${language}_FLAGS_${config}
        " -fstack-protector-strong -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2")
    endforeach()
    foreach(kind IN ITEMS EXE SHARED MODULE)
      string(APPEND CMAKE_${kind}_LINKER_FLAGS_${config} " -Wl,-z,relro,-z,now,-z,noexecstack")
    endforeach()
  endforeach()
  if(CMAKE_BUILD_TYPE STREQUAL "Release" OR CMAKE_BUILD_TYPE STREQUAL "RelWithDebInfo" OR
      CMAKE_BUILD_TYPE STREQUAL "MinSizeRel")
    set(WATER_IS_HARDENED TRUE) # for the tests
  endif()
endif()
