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

/// The corners of an STL's text, word by word, as any white space parts them: nothing is passed over.
class StlText
{
public:
  explicit StlText(const std::string& content)
  {
    std::istringstream lines(content);
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);)
    {
      std::istringstream stream(line);
      ++number;
      bool is_name = false;  // what follows solid and endsolid on their lines
      for (std::string word; !is_name && stream >> word;)
      {
        words_.push_back({ word, number });
        is_name = lowered(word) == "solid" || lowered(word) == "endsolid";
      }
    }
  }

  Points points()
  {
    Points points;
    while (at_ < words_.size())
    {
      expect("solid");
      while (!isNext("endsolid"))
        readFacet(points);
      expect("endsolid");
    }
    return points;
  }

private:
  struct Word
  {
    std::string text;
    std::size_t line;
  };

  static std::string lowered(std::string word)
  {
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
    return word;
  }

  bool isNext(const std::string& word) const { return at_ < words_.size() && lowered(words_[at_].text) == word; }

  const Word& next(const std::string& expected)
  {
    if (at_ == words_.size())
      throw std::invalid_argument("ends early: expected '" + expected + "', as an STL has it");
    return words_[at_++];
  }

  void expect(const std::string& word)
  {
    const Word& found = next(word);
    if (lowered(found.text) != word)
      refuseLine(found.line, "'" + found.text.substr(0, 40) + "' stands where an STL has '" + word + "'");
  }

  double number()
  {
    const Word& found = next("a number");
    const auto value = parseNumber(found.text);
    if (!value || !std::isfinite(*value))
      refuseLine(found.line, "'" + found.text.substr(0, 40) + "' is not a finite number");
    return *value;
  }

  void readFacet(Points& points)
  {
    for (const char* const word : { "facet", "normal" })
      expect(word);
    for (int k = 0; k < 3; ++k)
      next("a number");  // normals are not used, and often not even numbers
    for (const char* const word : { "outer", "loop" })
      expect(word);
    for (int k = 0; k < 3; ++k)
    {
      expect("vertex");
      const double x = number(), y = number(), z = number();
      points.emplace_back(x, y, z);
    }
    for (const char* const word : { "endloop", "endfacet" })
      expect(word);
  }

  std::vector<Word> words_;
  std::size_t at_ = 0;
};

bool isStlText(const std::string& content)
{
  std::istringstream stream(content);
  std::string word;
  stream >> word;
  return word.size() == 5 &&
         std::equal(word.begin(), word.end(), "solid", [](unsigned char a, char b) { return std::tolower(a) == b; });
}

/// Lines of points, or an STL's text.
Points pointsOfText(const std::string& content)
{
  if (isStlText(content))
    return StlText(content).points();
  Points points;
  std::istringstream lines(content);
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);)
  {
    ++number;
    std::istringstream stream(line.substr(0, line.find('#')));
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
      words.push_back(word);
    if (!words.empty())
      points.push_back(pointOf(words, 0, number));
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
