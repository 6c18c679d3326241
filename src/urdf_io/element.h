// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>
#include <urdf_model/pose.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace pkm_workspace
{
namespace urdf_io
{
using tinyxml2::XMLElement;

/// The value of an attribute, empty where it is missing.
inline std::string textOf(const XMLElement* element, const char* attribute)
{
  const char* const text = element == nullptr ? nullptr : element->Attribute(attribute);
  return text == nullptr ? std::string() : text;
}

inline std::string nameOf(const XMLElement& element)
{
  return textOf(&element, "name");
}

inline std::vector<const XMLElement*> childrenOf(const XMLElement& parent, const char* name)
{
  std::vector<const XMLElement*> children;
  for (auto* child = parent.FirstChildElement(name); child != nullptr; child = child->NextSiblingElement(name))
    children.push_back(child);
  return children;
}

/// The number of an attribute as urdfdom reads it; nothing where it is missing or not a number (urdfdom tells).
inline std::optional<double> numberOf(const XMLElement* element, const char* attribute)
{
  try
  {
    const std::string text = textOf(element, attribute);
    return text.empty() ? std::nullopt : std::optional<double>(urdf::strToDouble(text.c_str()));
  }
  catch (const std::runtime_error&)
  {
    return std::nullopt;
  }
}

/// The three numbers of an attribute as urdfdom reads them; nothing where they are missing or not three numbers.
inline std::optional<Eigen::Vector3d> vectorOf(const XMLElement* element, const char* attribute)
{
  try
  {
    urdf::Vector3 v;
    v.init(textOf(element, attribute));
    return Eigen::Vector3d(v.x, v.y, v.z);
  }
  catch (const std::runtime_error&)
  {
    return std::nullopt;
  }
}
}  // namespace urdf_io
}  // namespace pkm_workspace
