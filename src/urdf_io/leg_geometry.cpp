// SPDX-License-Identifier: BSD-3-Clause
#include "leg_geometry.h"

#include <algorithm>
#include <cmath>

#include "number_text.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
/// Least sine of the angle between two axes that are said to meet at a point.
constexpr double LEAST_SINE = 0.01;

/// Where axes meet: a box that holds the point of each that is nearest to the others, wherever turns about them take
/// it.
struct MeetingPoint
{
  IntervalVector point;  ///< seen from one of the joints [m]
  double misfit;         ///< upper bound of the distances between the axes [m]; infinite for parallel axes
};

/// A straight line: the axis of a passive joint.
struct Line
{
  IntervalVector point;
  IntervalVector direction;
};

/// The axes, seen from the joint number @p base.
std::vector<Line> axesFrom(const std::vector<Hinge>& hinges, std::size_t base)
{
  std::vector<Line> axes;
  for (const Hinge& hinge : hinges)
    axes.push_back({ { 0.0, 0.0, 0.0 }, hinge.axis.enclosure });
  for (std::size_t i = base + 1; i < hinges.size(); ++i)
    axes[i].point = axes[i - 1].point + hinges[i].offset;
  for (std::size_t i = base; i > 0; --i)
    axes[i - 1].point = axes[i].point - hinges[i].offset;
  return axes;
}

IntervalVector grown(const IntervalVector& v, double radius)
{
  const Interval around(-radius, radius);
  return v + IntervalVector{ around, around, around };
}

IntervalVector hull(const IntervalVector& a, const IntervalVector& b)
{
  return { hull(a[0], b[0]), hull(a[1], b[1]), hull(a[2], b[2]) };
}

/// The common perpendicular of two axes ends at the two points nearest to each other (Cramer's rule).
MeetingPoint meetingPoint(const Line& a, const Line& b)
{
  const IntervalVector normal = cross(a.direction, b.direction);
  const Interval sine_squared = squaredNorm(normal);
  const IntervalVector offset = b.point - a.point;
  if (!(sine_squared.lower() > LEAST_SINE * LEAST_SINE))
    return { a.point, std::numeric_limits<double>::infinity() };
  if (offset == IntervalVector{ 0.0, 0.0, 0.0 })
    return { a.point, 0.0 };
  const Interval along_a = dot(cross(offset, b.direction), normal) / sine_squared;
  const Interval along_b = dot(cross(offset, a.direction), normal) / sine_squared;
  const Interval distance = abs(dot(offset, normal)) / sqrt(sine_squared);
  return { hull(a.point + along_a * a.direction, b.point + along_b * b.direction), distance.upper() };
}

double cosine(const IntervalVector& a, const IntervalVector& b)
{
  return std::abs(mid(a).normalized().dot(mid(b).normalized()));
}

/// The meeting point of all axes: of the two that are nearest to perpendicular, and the distances of the others from
/// it.
MeetingPoint meetingPoint(const std::vector<Line>& axes)
{
  std::size_t first = 0;
  std::size_t second = 1;
  for (std::size_t i = 0; i < axes.size(); ++i)
    for (std::size_t j = i + 1; j < axes.size(); ++j)
      if (cosine(axes[i].direction, axes[j].direction) < cosine(axes[first].direction, axes[second].direction))
      {
        first = i;
        second = j;
      }
  MeetingPoint meeting = meetingPoint(axes[first], axes[second]);
  if (!std::isfinite(meeting.misfit))
    return meeting;
  Interval misfit = meeting.misfit;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (i != first && i != second)
      misfit += norm(cross(meeting.point - axes[i].point, axes[i].direction));
  // From one nearest point to the next, and back: every turn moves the following ones by their distance at most.
  return { grown(meeting.point, 2.0 * misfit.upper()), misfit.upper() };
}

void checkMeeting(const std::vector<Hinge>& hinges, const char* place, double misfit, double allowed,
                  Problems& problems)
{
  if (misfit <= allowed)
    return;
  TextStream text;
  for (const Hinge& hinge : hinges)
    text << " '" << hinge.joint << "'";
  text << " at the " << place;
  if (std::isfinite(misfit))
    text << " do not meet: they are " << roundedText(misfit, 3) << " m apart, expected at most "
         << roundedText(urdf_tolerance::MEET, 3) << " L = " << roundedText(allowed, 3) << " m";
  else
    text << " are parallel, expected axes that meet in one point";
  complain(problems, "the axes of the passive joints", text.str());
}
}  // namespace

LegGeometry measureLeg(const Station& station, Problems& problems)
{
  const auto slider_axes = axesFrom(station.at_slider, station.at_slider.size() - 1);
  const auto wrist_axes = axesFrom(station.wrist, 0);
  const MeetingPoint slider = meetingPoint(slider_axes);
  const MeetingPoint platform = meetingPoint(wrist_axes);
  LegGeometry leg;
  leg.slider_point = station.at_slider.front().offset - slider_axes.front().point + slider.point;
  leg.strut = station.wrist.front().offset + platform.point - slider.point;
  leg.length = lengthOf(leg.strut);
  leg.platform = platform.point - wrist_axes.back().point - station.offset;
  if (station.turn > 0.0)
    leg.platform = grown(leg.platform, (Interval(station.turn) * norm(leg.platform)).upper());
  leg.misfit = std::max(slider.misfit, platform.misfit);
  if (!leg.length.certainlyPositive())
    complain(problems, "strut of link '", station.at_slider.back().child_link,
             "': its length L = ", numberText(leg.length.mid()), " m, expected a positive length");
  const double allowed = urdf_tolerance::MEET * leg.length.mid();
  checkMeeting(station.at_slider, "slider", slider.misfit, allowed, problems);
  checkMeeting(station.wrist, "platform", platform.misfit, allowed, problems);
  return leg;
}

HingePair bestPair(const std::vector<Hinge>& at_slider, const IntervalVector& strut)
{
  HingePair best{ 0, 1, 2.0 };
  for (std::size_t i = 0; i < at_slider.size(); ++i)
    for (std::size_t j = i + 1; j < at_slider.size(); ++j)
    {
      const auto& second = at_slider[j].axis.enclosure;
      const double defect = std::max(cosine(at_slider[i].axis.enclosure, second), cosine(second, strut));
      if (defect < best.defect)
        best = { i, j, defect };
    }
  return best;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
