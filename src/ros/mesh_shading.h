// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_section.h"
#include "pkm_workspace/paving/set_mesh.h"

namespace pkm_workspace
{
/// A mesh with the light that falls on its corners: smooth, but for creases. Triangles without an area are left out.
PaintedSurface shaded(const Mesh& mesh);

/// The direction out of the surface, across a triangle.
Eigen::Vector3d outwards(const PaintedTriangle& triangle);
}  // namespace pkm_workspace
