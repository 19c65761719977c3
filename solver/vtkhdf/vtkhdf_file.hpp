#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

namespace talus {

/// Writes the states that the index NAME.pvd of a run lists as one VTKHDF file of version 2.0: poly data with time
/// steps, which ParaView from 5.12 and VTK from 9.3 on read. Points, vertices, lines and all arrays are those of the
/// .vtp files, with their names, types and components. `progress` is called with the number of states written and that
/// of all. The file appears complete, or not at all.
/// Errors: IoError; InputError with file and line for files that `talus run` and `talus cell` do not write, for example
/// states with other arrays than the first one.
/// Source: VTKHDF file format, version 2.0 (Kitware 2023), https://docs.vtk.org.
void write_vtkhdf(const std::filesystem::path& index, const std::filesystem::path& file,
                  const std::function<void(std::size_t, std::size_t)>& progress);

}  // namespace talus
