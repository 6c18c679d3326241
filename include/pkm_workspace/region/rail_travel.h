// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "pkm_workspace/dexterity/machine_model.h"
#include "pkm_workspace/interval/affine_form.h"
#include "pkm_workspace/machine/machine.h"
#include "pkm_workspace/region/largest_region.h"

namespace pkm_workspace
{
/// What the travel leaves a region: a form that is not negative where it keeps a joint limit, or the search box [m].
struct TravelForm
{
  AffineForm<double> form;
  std::optional<Subject> limit{};  ///< which joint limit; nothing for the search box
};

/// How the regions of a query move along parallel rails. With e the direction of the first rail, every center is x + t
/// e with its place x in the plane where one coordinate is the level. t changes each joint value by t or -t and nothing
/// else of what a criterion asks for, so that places are all that has to be searched: a region c + K(h) that satisfies
/// the rest of the criterion at one t keeps its joint limits L_i <= r_i <= U_i, of the joint values r_i counted along
/// e, for
///   max (L_i - r_i(x + k)) <= t <= min (U_i - r_i(x + k)) over all legs i and points k of K(h),
/// as far as the search box leaves these t. Thread-safe: constant after construction.
class RailTravel
{
public:
  /// @param size_bound no region of the query is larger, proved
  /// @pre the rails are parallel; joint limits are asked for or there is a search box
  RailTravel(const Machine& machine, const RegionQuery& query, double size_bound);

  /// A flat box that contains the place of every center [m]; not valid where there is none.
  const Box& places() const { return places_; }
  /// A box that contains every center [m].
  Box centers() const;
  /// Whether limits or the search box may leave a place no t: otherwise each has one, and t is of no concern.
  bool binds() const { return binds_; }

  /// Appends forms over a box of points, flat across the axis, and the travel t = reach * delta[axis], |t| <= reach,
  /// that are not negative where these keep the joint limits [m]. Valid where the struts reach. None where nothing
  /// binds.
  void addForms(const CenteredBox<double>& points, std::vector<TravelForm>& forms) const;
  /// The same over a box of places: not negative where the center lies in the search box.
  void addSearchBox(const Box& places, std::vector<TravelForm>& forms) const;

  /// The place of a point, in floating point.
  Eigen::Vector3d placeOf(const Eigen::Vector3d& point) const;
  /// How n . placeOf(point) changes with the coordinates of the point.
  Eigen::Vector3d slopeOfPlace(Eigen::Vector3d n) const
  {
    n[axis_] -= n.dot(direction_) / direction_[axis_];
    return n;
  }
  /// Whether the limits and the search box leave a region at these points of its shape a center.
  bool leavesCenter(const Eigen::Vector3d& place, double size, const std::vector<GrowingVector>& points) const;
  /// The center in the middle of what they leave it, or one strut beyond the limit if there is but one: where a search
  /// asks for it, which settleHeight() moves.
  Eigen::Vector3d centerAt(const Eigen::Vector3d& place, double size, const std::vector<GrowingVector>& points) const;

private:
  /// Values of t, in floating point.
  struct Travel
  {
    double lower;
    double upper;
  };

  Box placesAt(double level) const;
  Interval travelOver(const Box& places) const;
  Interval jointRange(int leg, const Box& places) const;
  Interval alongRail(int leg) const;
  int sense(int leg) const { return senses_[static_cast<std::size_t>(leg)]; }
  bool alwaysLeavesTravel(double size_bound) const;
  Travel travelAt(const Eigen::Vector3d& place, double size, const std::vector<GrowingVector>& points) const;

  Machine machine_;
  MachineModel<double> model_;
  Criterion criterion_;
  ShapePtr shape_;
  std::optional<Box> search_box_;
  int axis_;
  Eigen::Vector3d direction_;       ///< the middle of e
  std::array<int, 3> senses_;       ///< 1, or -1 for a rail that points against e
  std::array<Interval, 3> limits_;  ///< L_i and U_i [m]
  bool binds_ = false;
  Box places_;
  double level_ = 0.0;  ///< [m]
  double reach_ = 0.0;  ///< [m]
};
}  // namespace pkm_workspace
