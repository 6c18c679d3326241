// SPDX-License-Identifier: BSD-3-Clause
#include "hinge_stops.h"

#include <algorithm>
#include <cmath>

#include "number_text.h"
#include "pkm_workspace/interval/curve.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
/// Cosine of the angle between axes, and between an axis and the strut, that count as perpendicular; the stops hold for
/// what they are.
constexpr double SQUARE = 1e-9;
/// Cosine of the angle between the first axis and the rail. As far from a serial singularity as this, |b| / L, the
/// strut does not pass that axis.
constexpr double ACROSS = 1e-12;

Interval toInterval(const Enclosed<double>& number)
{
  return { number.lower(), number.upper() };
}

Interval around(double radius)
{
  return { -radius, radius };
}

/// A limit of a joint, as the angle of the hinge that it turns with.
struct HingeLimit
{
  std::string joint;
  bool is_upper;   ///< of the joint
  double limit;    ///< of the joint [rad]
  bool is_most;    ///< whether the hinge turns no farther than the angle, rather than that far at least
  Interval angle;  ///< of the hinge [rad]
  Interval other;  ///< of the hinge at the joint's other limit [rad]
};

/// The limits of all joints that turn with one hinge.
std::vector<HingeLimit> limitsOn(const Hinge& hinge, const Model& model)
{
  std::vector<HingeLimit> limits;
  for (const std::string& name : model.document.joints)
  {
    const JointFollower& follower = model.masters.at(name);
    const urdf::Joint& joint = model.joint(name);
    if (follower.source != hinge.master || joint.type != urdf::Joint::REVOLUTE || follower.factor == 0.0)
      continue;
    const Interval ratio = Interval(hinge.factor) / Interval(follower.factor);
    const double ends[] = { joint.limits->lower, joint.limits->upper };
    const auto angle = [&](double end) { return ratio * (Interval(end) - Interval(follower.offset)); };
    for (const bool is_upper : { false, true })
      limits.push_back({ name, is_upper, ends[is_upper ? 1 : 0], is_upper == ratio.certainlyPositive(),
                         angle(ends[is_upper ? 1 : 0]), angle(ends[is_upper ? 0 : 1]) });
  }
  return limits;
}

/// The stops of the two hinges of one leg.
class Stops
{
public:
  Stops(const Hinge& first, const Hinge& second, const LegGeometry& leg, const IntervalVector& rail)
    : h1_(first.axis.enclosure), h2_(second.axis.enclosure), strut_(leg.strut), misfit_(around(8.0 * leg.misfit))
  {
    const Interval length = norm(strut_);
    cosine_ = dot(h1_, h2_);
    along_ = dot(strut_, h2_);
    if (!(cosine_.magnitude() <= SQUARE))
      problem_ = "the axes of '" + first.joint + "' and '" + second.joint + "' are not perpendicular";
    else if (!(along_.magnitude() <= SQUARE * length.lower()))
      problem_ = "the axis of '" + second.joint + "' is not across the strut";
    else if (!(dot(h1_, rail).magnitude() <= ACROSS))
      problem_ = "the axis of '" + first.joint + "' is not across the rail, so that the strut may turn through it";
    if (!problem_.empty())
      return;
    const IntervalVector across = h2_ - cosine_ * h1_;
    const IntervalVector normal = (Interval(1.0) / norm(across)) * across;  // k
    const IntervalVector reference = cross(h1_, normal);                    // g
    const Interval lever = dot(strut_, reference);
    if (lever.contains(0.0))
      problem_ = "the strut lies along the axis of '" + first.joint + "' at zero";
    const Interval sense(lever.mid() > 0.0 ? 1.0 : -1.0);
    reference_ = sense * reference;
    beside_ = -sense * normal;
    slack_ = ((abs(along_) + abs(cosine_) * length) / norm(across)).upper();
  }

  const std::string& problem() const { return problem_; }

  /// The turn about the first axis: n . Rot(h1, angle) (h1 x g) >= 0, and the opposite for an upper limit.
  StrutStop ofFirst(const HingeLimit& limit) const
  {
    const SineCosine turn(limit.angle);
    const Interval sense(limit.is_most ? -1.0 : 1.0);
    const IntervalVector direction = sense * (toInterval(turn.cosine) * beside_ - toInterval(turn.sine) * reference_);
    return { limit.joint, limit.is_upper, limit.limit, direction, around(slack_) + misfit_ };
  }

  /// n . h1 at that angle of the second hinge: nothing where the strut would have to pass the first axis before.
  std::optional<StrutStop> ofSecond(const HingeLimit& limit, std::string& problem) const
  {
    const Interval rise = dot(cross(h2_, strut_), h1_);
    if (limit.angle.mignitude() >= pi().upper())
      return std::nullopt;
    const SineCosine turn(limit.angle);
    const Interval sine = toInterval(turn.sine), cosine = toInterval(turn.cosine), part = along_ * cosine_;
    const Interval slope = sine * (part - dot(strut_, h1_)) + cosine * rise;
    if (slope.contains(0.0) || rise.contains(0.0))
      problem = "the strut lies along the first axis there, or at zero";
    if (!problem.empty() || slope.certainlyPositive() != rise.certainlyPositive())
      return std::nullopt;
    const Interval at = part * (Interval(1.0) - cosine) + cosine * dot(strut_, h1_) + sine * rise;
    const Interval sense(limit.is_most == rise.certainlyPositive() ? -1.0 : 1.0);
    return StrutStop{ limit.joint, limit.is_upper, limit.limit, sense * h1_, sense * at + misfit_ };
  }

private:
  IntervalVector h1_;
  IntervalVector h2_;
  IntervalVector strut_;
  Interval misfit_;           ///< what n may be off by, at both of its ends and twice there [m]
  Interval cosine_ = 0.0;     ///< h1 . h2
  Interval along_ = 0.0;      ///< n0 . h2 [m]
  IntervalVector reference_;  ///< g: where the strut points at zero but for its part along h1, of length 1
  IntervalVector beside_;     ///< h1 x g
  double slack_ = 0.0;        ///< upper bound of n's part out of the plane of h1 and g, in a frame turned with it [m]
  std::string problem_;
};

/// Joints with limits between the slider and the tcp link, or beside that way, which no hinge leads.
std::vector<std::string> ledByNone(const Station& station, const std::string& slider, const Model& model)
{
  std::vector<std::string> found;
  for (const std::string& name : model.document.joints)
  {
    const urdf::Joint& joint = model.joint(name);
    const std::string& source = model.masters.at(name).source;
    const bool is_led = std::any_of(station.at_slider.begin(), station.at_slider.end(),
                                    [&source](const Hinge& hinge) { return hinge.master == source; });
    if (joint.type != urdf::Joint::REVOLUTE || is_led)
      continue;
    const urdf::Link* link = &model.link(joint.parent_link_name);
    while (link != nullptr && link->name != slider && link->name != station.link)
      link = link->getParent().get();
    if (link != nullptr && link->name == slider)
      found.push_back(name);
  }
  return found;
}

bool includesZero(const HingeLimit& limit)
{
  return limit.is_most ? limit.angle.lower() >= 0.0 : limit.angle.upper() <= 0.0;
}

std::string sentence(const HingeLimit& limit, const std::string& reason)
{
  return "joint '" + limit.joint + "', " + (limit.is_upper ? "upper" : "lower") + " limit " + numberText(limit.limit) +
         " rad: " + reason;
}
}  // namespace

HingeStops hingeStops(const Station& station, const LegGeometry& leg, const RailOfHinges& rail, const Model& model)
{
  HingeStops result;
  const std::vector<Hinge>& hinges = station.at_slider;
  const std::optional<Stops> stops =
      hinges.size() == 2 ? std::make_optional<Stops>(hinges[0], hinges[1], leg, rail.axis) : std::nullopt;
  for (std::size_t k = 0; k < hinges.size(); ++k)
    for (const HingeLimit& limit : limitsOn(hinges[k], model))
    {
      std::string problem = stops ? stops->problem() : "it is one of three hinges of a ball joint: give ball_tilt_max";
      if (problem.empty() && !includesZero(limit))
        problem = "the machine's zero configuration is beyond it";
      const bool is_free = std::min(limit.angle.mignitude(), limit.other.mignitude()) >= pi().upper();
      const double widest = std::max(limit.angle.magnitude(), limit.other.magnitude());
      if (problem.empty() && k == 0 && !is_free && !(widest < (Interval(0.5) * pi()).lower()))
        problem =
            "a joint that turns the strut about the slider's axis by a quarter of a turn or more, either way, is "
            "no pair of half-spaces of its directions";
      if (problem.empty() && k == 0 && !is_free)
        result.stops.push_back(stops->ofFirst(limit));
      else if (problem.empty() && k == 1)
        if (const auto stop = stops->ofSecond(limit, problem))
          result.stops.push_back(*stop);
      if (!problem.empty())
        result.open.push_back(sentence(limit, problem));
    }
  for (const std::string& joint : ledByNone(station, rail.slider, model))
    result.open.push_back("joint '" + joint + "': it follows no hinge of the strut by <mimic>");
  return result;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
