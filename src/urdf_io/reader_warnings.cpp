// SPDX-License-Identifier: BSD-3-Clause
#include "reader_warnings.h"

#include "number_text.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
/// A misfit of this part of L and less is rounding, and not worth a word.
constexpr double ROUNDING = 1e-9;
/// Axes that are this near to perpendicular let a strut reach all directions but a few hundredths of a degree.
constexpr double PERPENDICULAR = 1e-3;

std::string nameOf(const urdf::Joint& joint)
{
  return "joint '" + joint.name + "': ";
}

std::string rangeText(double lower, double upper, const char* unit)
{
  return "[" + numberText(lower) + ", " + numberText(upper) + "] " + unit;
}

void warnOfSoftLimits(const urdf::Joint& joint, const char* unit, std::vector<std::string>& warnings)
{
  if (joint.safety)
    warnings.push_back(nameOf(joint) + "the soft limits " +
                       rangeText(joint.safety->soft_lower_limit, joint.safety->soft_upper_limit, unit) +
                       " of its <safety_controller> are not used");
}

void warnOfHinge(const urdf::Joint& joint, std::vector<std::string>& warnings)
{
  if (joint.type == urdf::Joint::REVOLUTE)
    warnings.push_back(nameOf(joint) + "the limits " + rangeText(joint.limits->lower, joint.limits->upper, "rad") +
                       " of this passive joint are not used");
  warnOfSoftLimits(joint, "rad", warnings);
}

void warnOfGeometry(const Rail& rail, const ClosedLeg& leg, std::vector<std::string>& warnings)
{
  const std::string name = "leg of rail '" + rail.joint->name + "': ";
  const double misfit = leg.geometry.misfit;
  if (misfit > ROUNDING * leg.geometry.length.mid())
    warnings.push_back(name + "the axes of passive joints meet only to " + roundedText(misfit, 3) +
                       " m; the answers hold for every way to close this gap, and are coarser for it");
  if (leg.tcp.turn > ROUNDING)
    warnings.push_back(name + "the wrist may turn the platform by up to " + roundedText(leg.tcp.turn, 3) +
                       " rad; the answers hold for all of it, and are coarser for it");
  const HingePair pair = bestPair(leg.tcp.at_slider, leg.geometry.strut);
  if (pair.defect > PERPENDICULAR)
    warnings.push_back(
        name + "the passive joints '" + leg.tcp.at_slider[pair.first].joint + "' and '" +
        leg.tcp.at_slider[pair.second].joint +
        "' cannot turn the strut in every direction: the second axis is not perpendicular to the first and"
        " to the strut; this limit is not used");
}
}  // namespace

std::vector<std::string> warningsAbout(const Model& model, const std::array<Rail, 3>& rails,
                                       const std::array<ClosedLeg, 3>& legs)
{
  std::vector<std::string> warnings = model.document.warnings;
  for (std::size_t i = 0; i < 3; ++i)
  {
    warnOfSoftLimits(*rails[i].joint, "m", warnings);
    for (const auto* const hinges : { &legs[i].tcp.at_slider, &legs[i].tcp.wrist })
      for (const Hinge& hinge : *hinges)
        warnOfHinge(model.joint(hinge.joint), warnings);
    warnOfGeometry(rails[i], legs[i], warnings);
  }
  return warnings;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
