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

/// Struts that are longer are hardly those of a machine [m].
constexpr double LONGEST_STRUT = 20.0;

using Notices = std::vector<Notice>;

std::string rangeText(double lower, double upper, const char* unit)
{
  return "[" + numberText(lower) + ", " + numberText(upper) + "] " + unit;
}

void warnOfSoftLimits(const urdf::Joint& joint, const char* unit, Notices& notices)
{
  if (!joint.safety)
    return;
  const std::string limits = rangeText(joint.safety->soft_lower_limit, joint.safety->soft_upper_limit, unit);
  notices.push_back(
      { "joint '" + joint.name + "': the soft limits " + limits + " of its <safety_controller> are not used",
        "the soft limits of <safety_controller> are not used", limits, joint.name });
}

void warnOfHinge(const urdf::Joint& joint, Notices& notices)
{
  if (joint.type == urdf::Joint::REVOLUTE)
  {
    const std::string limits = rangeText(joint.limits->lower, joint.limits->upper, "rad");
    notices.push_back({ "joint '" + joint.name + "': the limits " + limits +
                            " of this passive joint hold only where hinge limits are asked for",
                        "the limits of passive joints hold only where hinge limits are asked for", limits,
                        joint.name });
  }
  warnOfSoftLimits(joint, "rad", notices);
}

void warnOfRail(const urdf::Joint& joint, Notices& notices)
{
  if (!joint.limits)
    return;
  const char* const unit = joint.type == urdf::Joint::PRISMATIC ? "m" : "rad";
  if (joint.type != urdf::Joint::CONTINUOUS && joint.limits->lower == joint.limits->upper)
  {
    const std::string remedy =
        "; many exporters write 0 0 where no limits were set. Nothing can move within these joint limits: write the "
        "real ones into the URDF, or leave joint limits out of the question";
    const std::string value = numberText(joint.limits->lower) + " " + unit;
    notices.push_back({ "rail '" + joint.name + "' cannot move, its <limit> has lower = upper = " + value + remedy,
                        "rails cannot move, their <limit> has lower = upper" + remedy, value, joint.name });
  }
  warnOfSoftLimits(joint, unit, notices);
}

/// A machine of such a size is possible, and answered.
void warnOfSize(const std::array<Rail, 3>& rails, const std::array<ClosedLeg, 3>& legs, Notices& notices)
{
  for (std::size_t i = 0; i < 3; ++i)
    if (legs[i].geometry.length.lower() > LONGEST_STRUT)
    {
      const std::string length = roundedText(legs[i].geometry.length.mid(), 4) + " m";
      const std::string remedy =
          ": is the URDF in millimetres? Its lengths are metres; if it is, multiply those of all origins, limits and "
          "shapes by 0.001";
      notices.push_back({ "leg of rail '" + rails[i].joint->name + "': the strut is " + length + " long" + remedy,
                          "the struts are very long" + remedy, length, rails[i].joint->name });
    }
}

/// A spindle's tip may be what the user means by the tool point.
void warnOfTools(const Closure& closure, Notices& notices)
{
  const std::string remedy = "; name it with tool_link if it is meant";
  for (const Beyond& tool : closure.beyond)
    notices.push_back({ "link '" + tool.link + "' is fixed " + roundedText(tool.distance, 6) +
                            " m from where the legs meet, and is not the tool point" + remedy,
                        "links are fixed beyond where the legs meet, and are not the tool point" + remedy,
                        roundedText(tool.distance, 6) + " m", tool.link });
}

void warnOfGeometry(const Rail& rail, const ClosedLeg& leg, Notices& notices)
{
  const std::string& rail_name = rail.joint->name;
  const auto warn = [&](const std::string& one, const std::string& kind, const std::string& value) {
    notices.push_back({ "leg of rail '" + rail_name + "': " + one, kind, value, rail_name });
  };
  const std::string misfit = roundedText(leg.geometry.misfit, 3) + " m";
  const std::string coarser = "; the answers hold for every way to close this gap, and are coarser for it";
  if (leg.geometry.misfit > ROUNDING * leg.geometry.length.mid())
    warn("the axes of passive joints meet only to " + misfit + coarser,
         "the axes of passive joints meet only nearly" + coarser, misfit);
  const std::string turn = roundedText(leg.tcp.turn, 3) + " rad";
  const std::string all = "; the answers hold for all of it, and are coarser for it";
  if (leg.tcp.turn > ROUNDING)
    warn("the wrist may turn the platform by up to " + turn + all, "wrists may turn the platform" + all,
         "up to " + turn);
  const HingePair pair = bestPair(leg.tcp.at_slider, leg.geometry.strut);
  if (pair.defect > PERPENDICULAR)
  {
    const std::string joints =
        "'" + leg.tcp.at_slider[pair.first].joint + "' and '" + leg.tcp.at_slider[pair.second].joint + "'";
    const std::string why =
        " cannot turn the strut in every direction: the second axis is not perpendicular to the first and to the "
        "strut; this limit is not used";
    warn("the passive joints " + joints + why, "pairs of passive joints" + why, joints);
  }
}
}  // namespace

std::vector<std::string> warningsAbout(const Model& model, const std::array<Rail, 3>& rails, const Closure& closure)
{
  const std::array<ClosedLeg, 3>& legs = closure.legs;
  Notices notices = model.document.warnings;
  for (std::size_t i = 0; i < 3; ++i)
  {
    warnOfRail(*rails[i].joint, notices);
    if (rails[i].form == LegForm::CRANK)
      warnOfHinge(*elbowOf(*rails[i].joint, model).back(), notices);
    for (const auto* const hinges : { &legs[i].tcp.at_slider, &legs[i].tcp.wrist })
      for (const Hinge& hinge : *hinges)
        warnOfHinge(model.joint(hinge.joint), notices);
    warnOfGeometry(rails[i], legs[i], notices);
  }
  warnOfSize(rails, legs, notices);
  warnOfTools(closure, notices);
  return sentencesOf(notices);
}
}  // namespace urdf_io
}  // namespace pkm_workspace
