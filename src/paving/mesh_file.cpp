// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/mesh_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

#include "pkm_workspace/common/byte_order.h"
#include "pkm_workspace/common/text.h"
#include "pkm_workspace/common/whole_file.h"

namespace pkm_workspace
{
namespace
{
constexpr std::size_t STL_HEADER = 80;

void put(const Eigen::Vector3f& vector, ByteWriter& writer)
{
  for (int k = 0; k < 3; ++k)
  {
    std::uint32_t bits;
    std::memcpy(&bits, &vector[k], sizeof(bits));
    writer.number(bits);
  }
}

/// As much of a title as there is room for: whole parts between commas that are in no brackets, one at the least.
std::string fitting(std::string title, std::size_t most)
{
  const auto count = [&title](char letter) { return std::count(title.begin(), title.end(), letter); };
  for (std::size_t end = 0; (title.size() > most || count('[') != count(']')) && end != std::string::npos;)
    if (end = title.rfind(", "); end != std::string::npos)
      title.resize(end);
  return title;
}

/// Header, number of triangles; each triangle: normal, corners, two bytes that mean nothing.
std::string stlOf(const Mesh& mesh, const std::string& title)
{
  const std::string begin = "STL of ";  // a file that begins with "solid" would be a text
  std::string header = begin + fitting(title, STL_HEADER - begin.size());
  header.resize(STL_HEADER, ' ');
  ByteWriter writer;
  writer.raw(header.data(), header.size());
  writer.number(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles)
  {
    const Eigen::Vector3f& a = mesh.vertices[triangle[0]];
    const Eigen::Vector3f& b = mesh.vertices[triangle[1]];
    const Eigen::Vector3f& c = mesh.vertices[triangle[2]];
    const Eigen::Vector3d normal = (b - a).cast<double>().cross((c - a).cast<double>()).normalized();
    put(normal.cast<float>(), writer);
    for (const Eigen::Vector3f* corner : { &a, &b, &c })
      put(*corner, writer);
    writer.number(std::uint16_t(0));
  }
  return writer.bytes();
}

std::string plyOf(const Mesh& mesh, std::string title)
{
  std::replace(title.begin(), title.end(), '\n', ' ');
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment " + title + "\nelement vertex " +
      std::to_string(mesh.vertices.size()) + "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
      std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  ByteWriter writer;
  writer.raw(header.data(), header.size());
  for (const Eigen::Vector3f& vertex : mesh.vertices)
    put(vertex, writer);
  for (const auto& triangle : mesh.triangles)
  {
    writer.number(std::uint8_t(3));
    for (const std::uint32_t corner : triangle)
      writer.number(corner);
  }
  return writer.bytes();
}
}  // namespace

bool isMeshFile(const std::string& path)
{
  return hasEnding(path, ".stl") || hasEnding(path, ".ply");
}

void saveMesh(const std::string& path, const Mesh& mesh, const std::string& title)
{
  if (!isMeshFile(path))
    throw std::invalid_argument(path + ": the name of a mesh's file must end in .stl or .ply");
  writeWholeFile(path, hasEnding(path, ".stl") ? stlOf(mesh, title) : plyOf(mesh, title));
}
}  // namespace pkm_workspace
