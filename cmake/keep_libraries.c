// SPDX-License-Identifier: BSD-3-Clause
// keep_libraries.c: for builds with sanitizers only: no library is ever unloaded.
//
// A graphics driver that is gone when the process ends has no name any more in the leak report, so
// lsan.supp could not tell its leaks from ours.
int dlclose(void* handle);

__attribute__((visibility("default"))) int dlclose(void* handle)
{
  (void)handle;
  return 0;
}
