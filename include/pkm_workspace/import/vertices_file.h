// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace pkm_workspace
{
/// The points of a file, each once: of an STL, binary or in ASCII, the corners of its triangles, otherwise one a line
/// as X Y Z, where empty lines and what follows a # are skipped. Numbers as they stand there: an STL has no unit.
/// @throws std::invalid_argument with the file, the line where there is one, and what is expected
std::vector<Eigen::Vector3d> readVertices(const std::string& path);
/// The same of a text; the reason does not name a file.
std::vector<Eigen::Vector3d> verticesIn(const std::string& content);
}  // namespace pkm_workspace
