// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>

#include "document_checks.h"
#include "number_text.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
/// The largest number that a position [m] or an angle [rad] may have.
constexpr double LARGEST_NUMBER = 1e9;

/// The elements of a joint, each with its attributes.
const std::map<std::string, std::vector<std::string>>& knownElements()
{
  static const std::map<std::string, std::vector<std::string>> known{
    { "parent", { "link" } },
    { "child", { "link" } },
    { "origin", { "xyz", "rpy" } },
    { "axis", { "xyz" } },
    { "limit", { "lower", "upper", "effort", "velocity" } },
    { "mimic", { "joint", "multiplier", "offset" } },
    { "dynamics", { "damping", "friction" } },
    { "calibration", { "rising", "falling", "reference_position" } },
    { "safety_controller", { "soft_lower_limit", "soft_upper_limit", "k_position", "k_velocity" } },
  };
  return known;
}

/// One joint with what is said about it.
struct Place
{
  const XMLElement& joint;
  Problems& problems;

  template <class... Parts>
  void complain(const Parts&... parts) const
  {
    pkm_workspace::complain(problems, "joint '", nameOf(joint), "': ", parts...);
  }
  bool isOf(std::initializer_list<const char*> types) const
  {
    const std::string type = textOf(&joint, "type");
    return std::find(types.begin(), types.end(), type) != types.end();
  }
  const char* unit() const { return isOf({ "prismatic" }) ? "m" : "rad"; }
};

void checkElements(const Place& place, std::vector<Notice>& warnings)
{
  for (const auto& known : knownElements())
  {
    const auto count = childrenOf(place.joint, known.first.c_str()).size();
    if (count > 1)
      place.complain("<", known.first, "> is given ", count, " times, expected once");
  }
  const std::string name = nameOf(place.joint);
  const auto warn = [&](const std::string& sentence) {
    warnings.push_back({ "joint '" + name + "': " + sentence, sentence, "", name });
  };
  for (auto* child = place.joint.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
  {
    const auto known = knownElements().find(child->Name());
    if (known == knownElements().end())
      warn(std::string("<") + child->Name() + "> is not an element of a joint and not used");
    for (auto* it = child->FirstAttribute(); it != nullptr && known != knownElements().end(); it = it->Next())
      if (std::find(known->second.begin(), known->second.end(), it->Name()) == known->second.end())
        warn(std::string("<") + child->Name() + " " + it->Name() + "> is not an attribute of it and not used");
  }
}

void checkLinks(const Place& place)
{
  for (const char* const end : { "parent", "child" })
  {
    const auto* const element = place.joint.FirstChildElement(end);
    if (element != nullptr && element->Attribute("link") != nullptr && textOf(element, "link").empty())
      place.complain("<", end, " link> is empty, expected the name of a link");
  }
}

void checkOrigin(const Place& place)
{
  const auto* const origin = place.joint.FirstChildElement("origin");
  for (const char* const attribute : { "xyz", "rpy" })
  {
    const auto numbers = vectorOf(origin, attribute);
    if (numbers && numbers->cwiseAbs().maxCoeff() > LARGEST_NUMBER)
      place.complain("<origin ", attribute, "> = ", vectorText(*numbers),
                     (attribute == std::string("xyz") ? " m" : " rad"), " is out of range, expected numbers from ",
                     -LARGEST_NUMBER, " to ", LARGEST_NUMBER);
  }
}

void checkAxis(const Place& place)
{
  if (!place.isOf({ "prismatic", "revolute", "continuous", "planar" }))
    return;
  const auto* const axis = place.joint.FirstChildElement("axis");
  if (axis == nullptr || axis->Attribute("xyz") == nullptr)
  {
    place.complain("<axis xyz> is missing, expected a direction (URDF would take 1 0 0)");
    return;
  }
  const auto direction = vectorOf(axis, "xyz");
  if (direction && direction->isZero(0.0))
    place.complain("<axis xyz> = 0 0 0 is not a direction, expected a vector of any length but 0");
}

void checkLimitEnds(const Place& place, const XMLElement& limit)
{
  for (const char* const end : { "lower", "upper" })
    if (limit.Attribute(end) == nullptr)
      place.complain("<limit ", end, "> is missing, expected a number [", place.unit(), "] (URDF would take 0)");
  const auto lower = numberOf(&limit, "lower");
  const auto upper = numberOf(&limit, "upper");
  if (lower && upper && *lower > *upper)
    place.complain("<limit> lower = ", numberText(*lower), " ", place.unit(), " is above upper = ", numberText(*upper),
                   " ", place.unit(), ", expected lower <= upper");
}

void checkLimit(const Place& place)
{
  const auto* const limit = place.joint.FirstChildElement("limit");
  if (limit == nullptr)
    return;
  if (place.isOf({ "prismatic", "revolute" }))
    checkLimitEnds(place, *limit);
  const bool slides = place.isOf({ "prismatic" });
  const std::pair<const char*, const char*> bounds[] = { { "effort", slides ? "N" : "N m" },
                                                         { "velocity", slides ? "m/s" : "rad/s" } };
  for (const auto& bound : bounds)
  {
    const auto value = numberOf(limit, bound.first);
    if (value && *value < 0.0)
      place.complain("<limit ", bound.first, "> = ", numberText(*value), " ", bound.second,
                     " is negative, expected 0 or more");
  }
}
}  // namespace

void checkJoints(const XMLElement& robot, Problems& problems, std::vector<Notice>& warnings)
{
  for (const auto* const joint : childrenOf(robot, "joint"))
  {
    const Place place{ *joint, problems };
    checkElements(place, warnings);
    checkLinks(place);
    checkOrigin(place);
    checkAxis(place);
    checkLimit(place);
  }
}
}  // namespace urdf_io
}  // namespace pkm_workspace
