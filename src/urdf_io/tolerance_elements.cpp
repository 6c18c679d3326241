// SPDX-License-Identifier: BSD-3-Clause
#include "tolerance_elements.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

#include "notice.h"
#include "number_text.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
std::string placeOf(const ToleranceElement& element)
{
  return "line " + std::to_string(element.line) + ": <" + TOLERANCES +
         (element.joint.empty() ? ">: " : " joint=\"" + element.joint + "\">: ");
}

/// Nothing where one of the words is no number.
std::vector<double> numbersIn(const std::string& text)
{
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;)
    if (const auto number = parseNumber(word))
      numbers.push_back(*number);
    else
      return {};
  return numbers;
}

void readAttribute(const tinyxml2::XMLAttribute& attribute, ToleranceElement& element, Problems& problems)
{
  const ToleranceKind* const kind = toleranceKind(attribute.Name());
  if (kind == nullptr)
  {
    std::string known = "joint";
    for (const ToleranceKind& one : TOLERANCE_KINDS)
      known += std::string(", ") + one.name;
    complain(problems, placeOf(element), "it has no attribute ", attribute.Name(), "; these are: ", known);
    return;
  }
  const std::vector<double> numbers = numbersIn(attribute.Value());
  try
  {
    if (numbers.empty())
      throw std::invalid_argument(std::string(kind->name) + "=\"" + attribute.Value() +
                                  "\" must be a number >= 0, or three, in " + kind->unit);
    Tolerances all;
    element.joint.empty() ? setTolerance(*kind, numbers, all) : setTolerance(*kind, numbers, all[0]);
    if (element.joint.empty() && numbers.size() > 1)
      throw std::invalid_argument(std::string(kind->name) +
                                  " has one number for all legs; give one leg its own with joint=\"NAME\"");
    element.kinds.emplace_back(kind, numbers);
  }
  catch (const std::invalid_argument& reason)
  {
    complain(problems, placeOf(element), reason.what());
  }
}

/// Elements of ours that nobody would read.
void checkOwnNames(const XMLElement& parent, Problems& problems)
{
  for (auto* child = parent.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
  {
    const bool is_root = parent.Parent() != nullptr && parent.Parent()->ToDocument() != nullptr;
    const std::string name = child->Name();
    if (name.rfind("pkm_", 0) == 0 && !(name == TOLERANCES && is_root))
      complain(problems, "line ", child->GetLineNum(), ": <", name, "> is not understood within <", parent.Name(),
               ">; of pkm_workspace's own elements there is <", TOLERANCES, "> within <robot>");
    checkOwnNames(*child, problems);
  }
}
}  // namespace

std::vector<ToleranceElement> toleranceElements(const XMLElement& robot, Problems& problems)
{
  std::vector<ToleranceElement> elements;
  std::set<std::string> about;
  for (const XMLElement* const found : childrenOf(robot, TOLERANCES))
  {
    ToleranceElement element{ found->GetLineNum(), textOf(found, "joint"), {} };
    if (!about.insert(element.joint).second)
      complain(problems, placeOf(element), "a second one ", element.joint.empty() ? "for all legs" : "for this joint",
               ", expected one");
    for (auto* attribute = found->FirstAttribute(); attribute != nullptr; attribute = attribute->Next())
      if (attribute->Name() != std::string("joint"))
        readAttribute(*attribute, element, problems);
    if (found->FirstAttribute() == nullptr || found->FirstChildElement() != nullptr)
      complain(problems, placeOf(element), "expected attributes such as tolerance_length=\"0.0001\", and no elements");
    elements.push_back(element);
  }
  checkOwnNames(robot, problems);
  return elements;
}

Tolerances tolerancesOf(const std::vector<ToleranceElement>& elements, const std::array<std::string, 3>& rails,
                        Problems& problems)
{
  Tolerances tolerances;
  for (const bool for_all : { true, false })
    for (const ToleranceElement& element : elements)
    {
      const auto rail = std::find(rails.begin(), rails.end(), element.joint);
      if (element.joint.empty() != for_all)
        continue;
      if (!for_all && rail == rails.end())
        complain(problems, placeOf(element), "there is no such rail, expected one of ",
                 listOf({ rails.begin(), rails.end() }));
      for (const auto& [kind, numbers] : element.kinds)
        if (for_all)
          setTolerance(*kind, numbers, tolerances);
        else if (rail != rails.end())
          setTolerance(*kind, numbers, tolerances[static_cast<std::size_t>(rail - rails.begin())]);
    }
  return tolerances;
}

std::vector<std::vector<std::pair<const char*, std::string>>> toleranceAttributes(
    const Tolerances& tolerances, const std::array<std::string, 3>& rails)
{
  std::vector<std::vector<std::pair<const char*, std::string>>> elements;
  const auto countsOf = [&](const ToleranceKind& kind) { return pkm_workspace::numbersOf(kind, tolerances).size(); };
  const bool are_alike = std::all_of(TOLERANCE_KINDS.begin(), TOLERANCE_KINDS.end(),
                                     [&](const ToleranceKind& kind) { return countsOf(kind) == 1; });
  for (std::size_t leg = 0; leg < (are_alike ? 1U : 3U); ++leg)
  {
    StrutTolerance of = tolerances[leg];
    if (of.isZero())
      continue;
    elements.emplace_back();
    if (!are_alike)
      elements.back().emplace_back("joint", rails[leg]);
    for (const ToleranceKind& kind : TOLERANCE_KINDS)
    {
      const double* const values = kind.values(of);
      const std::size_t each = kind.is_per_axis && !are_alike ? 3 : 1;
      std::string text;
      for (std::size_t k = 0; k < each; ++k)
        text += (k == 0 ? "" : " ") + numberText(values[k]);
      if (std::any_of(values, values + each, [](double x) { return x > 0.0; }))
        elements.back().emplace_back(kind.name, text);
    }
  }
  return elements;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
