// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace pkm_workspace
{
namespace test
{
/// The text with its only @p from, between @p begin and @p end, replaced. @throws std::invalid_argument unless it is
/// the only one
inline std::string replacedBetween(const std::string& text, std::size_t begin, std::size_t end, const std::string& from,
                                   const std::string& to)
{
  const std::string part = text.substr(begin, end - begin);
  const std::size_t place = part.find(from);
  if (place == std::string::npos || part.find(from, place + 1) != std::string::npos)
    throw std::invalid_argument("not exactly one '" + from + "' in:\n" + part);
  return text.substr(0, begin) + part.substr(0, place) + to + part.substr(place + from.size()) + text.substr(end);
}

/// The URDF with the only @p from in it replaced.
inline std::string replaced(const std::string& urdf, const std::string& from, const std::string& to)
{
  return replacedBetween(urdf, 0, urdf.size(), from, to);
}

/// The URDF with the only @p from in the element of one joint replaced.
inline std::string withJoint(const std::string& urdf, const std::string& joint, const std::string& from,
                             const std::string& to)
{
  const std::size_t begin = urdf.find("<joint name=\"" + joint + "\"");
  if (begin == std::string::npos)
    throw std::invalid_argument("no joint '" + joint + "'");
  return replacedBetween(urdf, begin, urdf.find("</joint>", begin) + 8, from, to);
}

/// The URDF with @p elements put before the end of the robot.
inline std::string withElements(const std::string& urdf, const std::string& elements)
{
  return replaced(urdf, "</robot>", elements + "</robot>");
}

/// A link @p name on a joint of the same name.
inline std::string branch(const std::string& name, const std::string& type, const std::string& parent,
                          const std::string& rest = "")
{
  return "<link name=\"" + name + "\"/><joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + name + "\"/>" + rest + "</joint>";
}

/// The URDF on a link "world", at @p origin (the attributes of an <origin>).
inline std::string mounted(const std::string& urdf, const std::string& origin)
{
  return withElements(urdf,
                      "<link name=\"world\"/><joint name=\"mount\" type=\"fixed\"><parent link=\"world\"/>"
                      "<child link=\"base_link\"/><origin " +
                          origin + "/></joint>");
}
}  // namespace test
}  // namespace pkm_workspace
