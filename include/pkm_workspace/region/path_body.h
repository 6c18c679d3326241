// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "pkm_workspace/region/joint_rates.h"
#include "pkm_workspace/region/own_proof.h"
#include "pkm_workspace/region/path_tree.h"

namespace pkm_workspace
{
/// What is to be placed: the moves of a job, or a solid part.
struct Workpiece
{
  PathTree moves;
  ShapePtr solid = nullptr;                             ///< a polytope about the reference, in place of moves
  Eigen::Vector3d reference = Eigen::Vector3d::Zero();  ///< about which it is scaled [m]

  /// Contains it [m].
  Box bounds() const;
  /// The least z of its points, but for rounding [m].
  double lowest() const;
};

/// The points of a workpiece, moved by the center (a translation), as a family in its size h. Either with a margin:
/// each of them moved by up to h along each axis. Or swept: each of them at every scale from s to s + h about the
/// reference, s = 1 or 0. Both are nested in h.
class PathBody : public Shape, public OwnProof
{
public:
  enum class Grows
  {
    MARGIN,  ///< size: margin [m]
    SCALE    ///< size: what the scale is above the least one
  };

  /// @param limits that joints keep at the tool's speeds, by the proof, too; of a margin only
  PathBody(std::shared_ptr<const Workpiece> workpiece, Grows grows, double least_scale = 1.0,
           const JointRateLimits& limits = {});

  const Workpiece& workpiece() const { return *workpiece_; }

  double slack(double size) const override;
  ContainmentResult prove(const BoxTest& test, const Eigen::Vector3d& center, double size,
                          const Budget& budget) const override;
  bool refutes(const BoxTest& test, const Box& centers, double size) const override;

  const OwnProof* ownProof() const override { return this; }
  std::string name() const override { return "job"; }
  std::string sizeMeaning() const override { return grows_ == Grows::MARGIN ? "margin [m]" : "scale, less the least"; }
  GrowingVector lower() const override;
  GrowingVector upper() const override;
  std::vector<GrowingVector> extremePoints() const override { return extremes_; }
  HalfSpace halfSpace(const Box&, const Eigen::Vector3d&, double) const override { return {}; }
  bool misses(const Box&, const Eigen::Vector3d&, double) const override { return false; }
  bool contains(const Eigen::Vector3d&, const Box&, double) const override { return false; }
  std::optional<AffineForm<double>> avoidance(const Eigen::Vector3d&, const Box&, double) const override { return {}; }
  std::optional<GrowingVector> placeOf(const Eigen::Vector3d&, double) const override { return {}; }
  Growing<Interval> support(const IntervalVector& n) const override;
  Eigen::Vector3d exit(const Eigen::Vector3d&, const Eigen::Vector3d&, double) const override;
  Growing<double> support(const Eigen::Vector3d& n) const override;
  Eigen::Vector3d nearest(const Eigen::Vector3d& point, const Eigen::Vector3d& center, double size) const override;
  std::vector<double> dimensions(double) const override { return {}; }
  Interval volume(double) const override { return Interval(0.0); }

private:
  class Proof;
  static constexpr int ARC_POINTS = 16;

  /// A point of the moves where joints go fast.
  struct FastPoint
  {
    PathTree::Part part;
    double t;
  };

  /// A plane along an edge of the solid and an axis: its points x, as seen from the reference, satisfy
  /// normal . x <= most.
  struct EdgePlane
  {
    Eigen::Vector3d normal;
    double most;
  };

  void makeEdgePlanes();
  void learnOutline(const GrowingVector& place) const;
  void learnFast(const FastPoint& fast) const;
  GrowingVector placeOfPoint(const Eigen::Vector3d& point, const Eigen::Vector3d& along) const;
  /// Hands out points of the workpiece: all that can be extreme, of arcs some.
  template <class Use>
  void forEachPoint(const Use& use) const
  {
    if (workpiece_->solid)
      for (const GrowingVector& corner : workpiece_->solid->extremePoints())
        use(workpiece_->reference + corner.per_size);
    for (std::uint32_t index = 0; index < workpiece_->moves.size(); ++index)
    {
      const Curve& curve = workpiece_->moves.curve({ 0, index });
      const int last = curve.angle() == Interval(0.0) ? 1 : ARC_POINTS;
      for (int k = 0; k <= last; ++k)
        use(mid(curve.point(static_cast<double>(k) / last)));
    }
  }
  void chooseExtremes();
  template <class Extremes>
  void addPlaces(const Extremes& extremes, std::vector<GrowingVector>& places) const;
  bool isTooFast(const BoxTest& test, const FastPoint& fast, const CenteredBox<double>& centers, double size) const;

  std::shared_ptr<const Workpiece> workpiece_;
  Grows grows_;
  double least_scale_;
  JointRateLimits limits_;
  Box bounds_;
  double slack_;                                ///< of points at scale 1 [m]
  std::vector<EdgePlane> edge_planes_;          ///< of a solid
  std::vector<GrowingVector> extremes_;         ///< few
  mutable std::vector<GrowingVector> outline_;  ///< many; proofs add to them
  mutable std::vector<FastPoint> fast_;         ///< learnt by proofs
};
}  // namespace pkm_workspace
