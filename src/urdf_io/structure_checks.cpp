// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <set>

#include "document_checks.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
/// For each name the next one on its way; a way that comes back to where it began is a circle.
using Ways = std::map<std::string, std::string>;

/// The names on the circle that begins and ends with @p start, or none.
std::vector<std::string> circleFrom(const std::string& start, const Ways& ways)
{
  std::vector<std::string> circle{ start };
  for (auto way = ways.find(start); way != ways.end() && circle.size() <= ways.size(); way = ways.find(way->second))
  {
    circle.push_back(way->second);
    if (way->second == start)
      return circle;
  }
  return {};
}

/// Calls @p tell with each circle once, as text.
template <class Tell>
void forEachCircle(const Ways& ways, const Tell& tell)
{
  std::set<std::string> told;
  for (const auto& way : ways)
  {
    const auto circle = circleFrom(way.first, ways);
    if (circle.empty() || !told.insert(way.first).second)
      continue;
    std::string text = "'" + circle.front() + "'";
    for (std::size_t i = 1; i < circle.size(); ++i)
      text += " -> '" + circle[i] + "'";
    told.insert(circle.begin(), circle.end());
    tell(text);
  }
}

void checkNames(const XMLElement& robot, Problems& problems)
{
  if (nameOf(robot).empty() && robot.Attribute("name") != nullptr)
    complain(problems, "<robot name> is empty, expected the name of the machine");
  for (const char* const kind : { "link", "joint" })
    for (const auto* const element : childrenOf(robot, kind))
      if (element->Attribute("name") != nullptr && nameOf(*element).empty())
        complain(problems, "line ", element->GetLineNum(), ": <", kind, " name> is empty, expected a name");
}

void checkParents(const XMLElement& robot, Problems& problems)
{
  std::map<std::string, std::string> joint_above;
  Ways parents;
  for (const auto* const joint : childrenOf(robot, "joint"))
  {
    const std::string child = textOf(joint->FirstChildElement("child"), "link");
    const auto inserted = joint_above.emplace(child, nameOf(*joint));
    if (!inserted.second && !child.empty())
      complain(problems, "link '", child, "' has two parents, joints '", inserted.first->second, "' and '",
               nameOf(*joint), "', expected one");
    parents.emplace(child, textOf(joint->FirstChildElement("parent"), "link"));
  }
  forEachCircle(parents, [&problems](const std::string& circle) {
    complain(problems, "links form a loop, each the child of the next: ", circle,
             "; expected a tree, cut at the platform");
  });
}

void checkMimics(const XMLElement& robot, Problems& problems)
{
  std::set<std::string> joints;
  for (const auto* const joint : childrenOf(robot, "joint"))
    joints.insert(nameOf(*joint));
  Ways followed;
  for (const auto* const joint : childrenOf(robot, "joint"))
  {
    const auto* const mimic = joint->FirstChildElement("mimic");
    if (mimic == nullptr || mimic->Attribute("joint") == nullptr)
      continue;
    const std::string source = textOf(mimic, "joint");
    if (source == nameOf(*joint))
      complain(problems, "joint '", source, "': <mimic> follows the joint itself, expected another joint");
    else if (joints.count(source) == 0)
      complain(problems, "joint '", nameOf(*joint), "': <mimic> follows '", source, "', which is not a joint");
    else
      followed.emplace(nameOf(*joint), source);
  }
  forEachCircle(followed, [&problems](const std::string& circle) {
    complain(problems, "joints follow each other in a circle by <mimic>: ", circle, "; expected one that follows none");
  });
}
}  // namespace

void checkStructure(const XMLElement& robot, Problems& problems)
{
  checkNames(robot, problems);
  checkParents(robot, problems);
  checkMimics(robot, problems);
}
}  // namespace urdf_io
}  // namespace pkm_workspace
