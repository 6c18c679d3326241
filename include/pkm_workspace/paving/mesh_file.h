// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/paving/set_mesh.h"

namespace pkm_workspace
{
/// Whether a name is that of a file of a mesh: it ends in .stl or .ply, in letters of any case.
bool isMeshFile(const std::string& path);

/// Writes a mesh as STL (binary) or PLY (binary), by the ending of the file's name; in metres. The file appears, or
/// replaces the one of that name, only when all of it is on the disk.
/// @param title in the file's header; an STL has room for some of its parts, which commas separate
/// @throws std::invalid_argument with the file's name and the reason
void saveMesh(const std::string& path, const Mesh& mesh, const std::string& title);
}  // namespace pkm_workspace
