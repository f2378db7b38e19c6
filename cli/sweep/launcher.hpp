// SPDX-License-Identifier: GPL-3.0-or-later
// What mpirun tells a process before MPI is there to be asked.
#pragma once

#include <cstdlib>
#include <initializer_list>

namespace orograph {

inline int launcher_number(const char* open_mpi, const char* pmi, int alone) {
  for (const char* name : {open_mpi, pmi})
    if (const char* text = std::getenv(name)) return std::atoi(text);
  return alone;
}

/// Processes started together, 1 where nothing started them; and which of them this one is.
inline int launched_size() {
  return launcher_number("OMPI_COMM_WORLD_SIZE", "PMI_SIZE", 1);
}
inline int launched_rank() {
  return launcher_number("OMPI_COMM_WORLD_RANK", "PMI_RANK", 0);
}

} // namespace orograph
