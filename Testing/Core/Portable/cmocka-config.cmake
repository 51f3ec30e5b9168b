# SPDX-License-Identifier: BSD-3-Clause
# find_package(cmocka) with this folder as cmocka_DIR: the header beside this file, and no library.
set(CMOCKA_INCLUDE_DIR "${CMAKE_CURRENT_LIST_DIR}")
set(CMOCKA_LIBRARIES)
