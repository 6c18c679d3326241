// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/import/vertices_file.h"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "pkm_workspace/common/byte_order.h"
#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

constexpr std::size_t LARGEST_MESH = std::size_t(1) << 28;  ///< bytes
constexpr std::size_t STL_HEAD = 84;                        ///< bytes before the triangles of a binary one
constexpr std::size_t STL_TRIANGLE = 50;                    ///< and of each of them

[[noreturn]] void refuseLine(std::size_t number, const std::string& why)
{
  throw std::invalid_argument("line " + std::to_string(number) + ": " + why);
}

std::size_t trianglesTold(const std::string& content)
{
  ByteReader reader(content, content.size());
  reader.raw(STL_HEAD - 4);
  return reader.number<std::uint32_t>();
}

bool isBinaryStl(const std::string& content)
{
  return content.size() >= STL_HEAD && content.size() == STL_HEAD + STL_TRIANGLE * trianglesTold(content);
}

Points pointsOfBinaryStl(const std::string& content)
{
  Points points;
  ByteReader reader(content, content.size());
  reader.raw(STL_HEAD);
  while (reader.left() >= STL_TRIANGLE)
  {
    reader.raw(3 * sizeof(float));  // the normal
    for (int corner = 0; corner < 3; ++corner)
    {
      float place[3];
      for (float& coordinate : place)
      {
        const auto bits = reader.number<std::uint32_t>();
        std::memcpy(&coordinate, &bits, sizeof(bits));
      }
      points.emplace_back(place[0], place[1], place[2]);
    }
    reader.raw(2);
  }
  return points;
}

Vector3d pointOf(const std::vector<std::string>& words, std::size_t first, std::size_t line)
{
  if (words.size() != first + 3)
    refuseLine(line, "needs 3 numbers (X Y Z), got " + std::to_string(words.size() - first));
  Vector3d point;
  for (const int axis : { 0, 1, 2 })
  {
    const std::string& word = words[first + static_cast<std::size_t>(axis)];
    const auto number = parseNumber(word);
    if (!number || !std::isfinite(*number))
      refuseLine(line, "'" + word.substr(0, 40) + "' is not a finite number");
    point[axis] = *number;
  }
  return point;
}

/// Lines of points, or those of an STL that begin with "vertex".
Points pointsOfText(const std::string& content)
{
  Points points;
  std::istringstream lines(content);
  bool is_stl = false;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);)
  {
    ++number;
    std::istringstream stream(line.substr(0, line.find('#')));
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
      words.push_back(word);
    is_stl = is_stl || (points.empty() && !words.empty() && words[0] == "solid");
    if (words.empty() || (is_stl && words[0] != "vertex"))
      continue;
    points.push_back(pointOf(words, is_stl ? 1 : 0, number));
  }
  return points;
}
}  // namespace

Points verticesIn(const std::string& content)
{
  if (content.find('\0') != std::string::npos && !isBinaryStl(content))
    throw std::invalid_argument("is neither a text nor a whole binary STL" +
                                (content.size() < STL_HEAD
                                     ? std::string()
                                     : ": as one it would have " + std::to_string(trianglesTold(content)) +
                                           " triangles, 50 bytes each after 84, "
                                           "and it has " +
                                           std::to_string(content.size()) + " bytes"));
  Points points = isBinaryStl(content) ? pointsOfBinaryStl(content) : pointsOfText(content);
  if (points.empty())
    throw std::invalid_argument("has no point: expected an STL, or lines of X Y Z");
  const auto key = [](const Vector3d& p) { return std::make_tuple(p.x(), p.y(), p.z()); };
  if (!std::all_of(points.begin(), points.end(), [](const Vector3d& p) { return p.allFinite(); }))
    throw std::invalid_argument("has a corner that is not finite");
  std::sort(points.begin(), points.end(), [&](const Vector3d& a, const Vector3d& b) { return key(a) < key(b); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

Points readVertices(const std::string& path)
{
  const std::string content = readWholeFile(path, LARGEST_MESH);
  try
  {
    return verticesIn(content);
  }
  catch (const std::invalid_argument& reason)
  {
    throw std::invalid_argument(path + ": " + reason.what());
  }
}
}  // namespace pkm_workspace
