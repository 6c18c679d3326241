// SPDX-License-Identifier: BSD-3-Clause
// The part of the proof that looks for bad points.
#include "path_body_proof.h"

#include <algorithm>

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// Steps from a solid to a box and back, each to the nearest point.
constexpr int APPROACHES = 8;
/// Points that are looked at side by side.
constexpr std::size_t MOST_AT_A_TIME = 1024;
/// Of the width of a box: parts that are narrower are as good as points there.
constexpr double FINE = 0.05;
/// How often the part that is nearest to a point is divided.
constexpr int DESCENT = 60;

/// How far a point is from a box, along the axis where that is most.
double distance(const Vector3d& point, const Box& box)
{
  return std::max(0.0, std::max((box.lower - point).maxCoeff(), (point - box.upper).maxCoeff()));
}
}  // namespace

/// Looks at the points that are likely to be bad first. @return whether one is
bool PathBody::Proof::refuteAtOutline()
{
  WorstPlace worst;
  look(body_.outline_, worst);
  return worst.margin < 0.0 && isBad(worst.place);
}

void PathBody::Proof::look(const std::vector<GrowingVector>& places, WorstPlace& worst) const
{
  const std::vector<Vector3d> points = pointsOf(places, center_, size_);
  std::vector<double> margins(points.size());
  test_.kernel().margins(points.data(), points.size(), margins.data());
  const auto least = std::min_element(margins.begin(), margins.end());
  if (least != margins.end() && *least < worst.margin)
    worst = { *least, places[static_cast<std::size_t>(least - margins.begin())] };
}

/// A bad place beside the outline: the worst one that differs in the point of the workpiece only is one that counts.
/// The outline learns it.
bool PathBody::Proof::isBadBeside(const GrowingVector& place)
{
  WorstPlace worst{ test_.margin(center_ + place.at(size_)), place };
  if (worst.margin >= 0.0)
    return false;
  std::vector<GrowingVector> places;
  const auto lookAtAll = [&] {
    look(places, worst);
    places.clear();
  };
  body_.forEachPoint([&](const Vector3d& point) {
    places.push_back(body_.placeOfPoint(point, place.per_size));
    if (places.size() == MOST_AT_A_TIME)
      lookAtAll();
  });
  lookAtAll();
  if (!isBad(worst.place) && !isBad(place))
    return false;
  body_.learnOutline(*result_.bad_place);
  return true;
}

/// The point of the solid that is nearest to a box, nearly.
Vector3d PathBody::Proof::nearestInSolid(const Box& box) const
{
  Vector3d of_box = box.center();
  Vector3d of_solid = of_box;
  for (int k = 0; k < APPROACHES; ++k)
  {
    of_solid = body_.workpiece_->solid->nearest(of_box, center_ + body_.workpiece_->reference, most_);
    of_box = of_solid.cwiseMax(box.lower).cwiseMin(box.upper);
  }
  return of_solid;
}

/// Where on the path it comes near to a point. @param enough width of a part that is not divided [m]
PathBody::Proof::Part PathBody::Proof::nearestPart(const Parts& parts, const Vector3d& target, double enough) const
{
  Part best{};
  double least = INF;
  const auto look = [&](const Part& part) {
    const double far = distance(target, placed(part));
    if (far < least)
    {
      least = far;
      best = part;
    }
  };
  std::for_each(parts.begin(), parts.end(), look);
  for (int k = 0; k < DESCENT && moves_.isDivisible(best.path) && placed(best).maxWidth() > enough; ++k)
  {
    const Part divided = best;
    least = INF;
    halve(divided, look);
  }
  return best;
}

std::optional<GrowingVector> PathBody::Proof::placeNear(const Node& node, const Vector3d& target) const
{
  if (!node.parts)
    return placeInSolid(target);
  const Part part = nearestPart(*node.parts, target, FINE * node.box.maxWidth());
  const Vector3d point = mid(moves_.curve(part.path).point(half(part.path.first, part.path.last)));
  if (body_.grows_ == Grows::MARGIN)
    return placeTowards(point, target);
  const GrowingVector whole = body_.placeOfPoint(point, Vector3d::Zero());
  return GrowingVector{ whole.fixed,
                        std::min(1.0, (half(part.low, part.high) - body_.least_scale_) / size_) * whole.per_size };
}

/// A point of the workpiece, moved as far towards the target as the margin lets it.
GrowingVector PathBody::Proof::placeTowards(const Vector3d& point, const Vector3d& target) const
{
  return body_.placeOfPoint(point, ((target - center_ - point) / size_).cwiseMax(-1.0).cwiseMin(1.0));
}

std::optional<GrowingVector> PathBody::Proof::placeInSolid(const Vector3d& target) const
{
  const Workpiece& piece = *body_.workpiece_;
  const Vector3d origin = center_ + piece.reference;
  const auto place = piece.solid->placeOf(nearestInSolid(thickened({ target, target }, reach_)) - origin, most_);
  if (!place)
    return std::nullopt;
  return placeTowards(piece.reference + place->per_size, target);
}

/// Looks whether the point that is nearest to the target is bad.
bool PathBody::Proof::findBad(const Node& node, const Vector3d& target)
{
  const std::optional<GrowingVector> near = placeNear(node, target);
  return near && isBadBeside(*near);
}

bool PathBody::Proof::isBad(const GrowingVector& place)
{
  const Vector3d point = center_ + place.at(size_);
  if (test_.classify(point) != BoxVerdict::OUTSIDE)
    return false;
  result_.verdict = Containment::OUTSIDE;
  result_.bad_point = point;
  result_.bad_place = place;
  return true;
}
}  // namespace pkm_workspace
