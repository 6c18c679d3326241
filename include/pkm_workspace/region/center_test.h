// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "pkm_workspace/common/branch_and_bound.h"
#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/interval/turning.h"
#include "pkm_workspace/region/candidate.h"
#include "pkm_workspace/region/linear_programme.h"
#include "pkm_workspace/region/own_proof.h"
#include "pkm_workspace/region/rail_travel.h"
#include "pkm_workspace/region/reason.h"
#include "pkm_workspace/region/witness_points.h"

namespace pkm_workspace
{
/// The question of branch and bound over centers (docs/theory.md, the largest region): may any center of a box carry a
/// region?
///
/// For every witness point k of K and every center c of the box, c + h k has to satisfy the criterion; for any vectors
/// v this makes v^T S v at c + h k, an affine form in the position delta of c within the box, necessarily non-negative.
/// A linear programme over all these forms finds weights mu >= 0 whose combination is negative on the whole box
/// (Farkas); the combination is then checked in sound arithmetic. Vectors are added where the programme's optimum still
/// violates definiteness (Kelley's cutting planes). Known bad points give forms too: no region may contain them. So do
/// spheres where struts are one: no region may lie on both sides. Along parallel rails the boxes are of places, and the
/// delta that they leave over is the travel: a combination then excludes all of it at once. Holds its working memory:
/// one object a thread.
class CenterTest
{
public:
  /// Keeps references: the witness points may grow between calls. @param travel where centers have places, or nullptr:
  /// the test is then of a criterion without joint limits
  /// @param keeps_reasons whether reason() can be asked for
  CenterTest(const BoxTest& test, const Shape& shape, const WitnessPoints& witnesses,
             const RailTravel* travel = nullptr, bool keeps_reasons = false);

  /// Why no center in the box, or with its place there, carries a region of this size, nor of a larger one; nothing
  /// where that is not proved.
  /// @param angles by any of which the region may be turned about the vertical, narrower than a quarter; a single 0
  /// where it is not to be turned. Of others there are no reasons
  std::optional<Closing> excludes(const Box& centers, double size, const Interval& angles = 0.0);

  /// After excludes() told why: what proves it.
  const Reason& reason() const { return reason_; }
  /// After excludes() told nothing: the optimum of the programme, without unit. The larger, the more room seems to be
  /// left.
  double room() const { return room_; }
  /// Whether nothing that is known so far speaks against one region, in floating point: neither the criterion at its
  /// witness points nor a bad point within it.
  bool isPromising(const Candidate& region);

private:
  /// How far a point of the body is beyond a strut sphere.
  struct Excess
  {
    GrowingVector place;
    TurningForm form;
  };

  /// A point that no region about one of the centers may contain.
  struct BadPoint
  {
    Eigen::Vector3d point;
    Box centers;
  };

  void place(const Box& centers, double size, const Interval& angles);
  TurningForm overNode(std::size_t place, const AffineForm<double>& form) const;
  std::optional<Closing> excludes(const Box& centers, double size, const BoxKernel& kernel);
  std::optional<Closing> excludesAlone(const Box& centers, double size, const BoxKernel& kernel);
  BadPoint alongThinAxes(const Eigen::Vector3d& known, const Box& centers, double size) const;
  bool addKnown(const Box& centers, double size);
  std::optional<TurningForm> avoidance(const BadPoint& bad, double size) const;
  bool addTravel(const Box& places, double size);
  bool addNecessary(std::size_t k);
  template <class Term>
  bool add(const TurningForm& form, const Term& term);
  bool addSphere(const StrutSphere& sphere, const Box& centers, double size);
  bool reachesInto(const StrutSphere& sphere, double size) const;
  bool combinationExcludes();
  bool addCuts();

  const BoxTest& test_;
  const Shape& shape_;
  const WitnessPoints& witnesses_;
  const RailTravel* travel_;
  const OwnProof* own_;                     ///< of bodies that are not convex, or nullptr
  const std::vector<StrutSphere> spheres_;  ///< none of those
  GrowingVector half_extents_;
  std::vector<NecessaryForms> necessary_;  ///< one for each witness point
  std::vector<TurningForm> forms_;
  std::vector<TravelForm> travel_forms_;
  std::vector<GrowingVector> between_;  ///< points of the family, exactly, between its extreme points
  CenteredBox<double> box_;             ///< moved by the place of a point, it holds those of its point
  std::vector<GrowingVector> places_;   ///< of the witness points, then of those between
  Interval angles_ = 0.0;               ///< by which regions may be turned [rad]
  std::optional<TurningBox> turning_;   ///< where regions may be turned: what these two are of
  std::vector<Excess> excesses_;        ///< of the witness points in the cone of a sphere
  std::vector<double> margins_;
  std::vector<Eigen::Vector3d> bad_;  ///< those near to the centers
  const bool keeps_reasons_;
  std::vector<FormOrigin> origins_;  ///< MOST for each witness point
  std::vector<ReasonTerm> terms_;    ///< one for each of the forms
  Reason reason_;                    ///< of the box that was excluded last
  LinearProgramme<5> programme_;     ///< unknowns: delta, tau of the angle, and the room in units of ROOM
  double room_ = 0.0;
};
}  // namespace pkm_workspace
