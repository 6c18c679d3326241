// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "pkm_workspace/common/branch_and_bound.h"
#include "pkm_workspace/region/path_body.h"

namespace pkm_workspace
{
/// Covers the points of a body by boxes, and these by smaller ones where they are undecided: each as small as the parts
/// of the path in it let it be.
class PathBody::Proof : public BranchingDefaults
{
public:
  Proof(const PathBody& body, const BoxTest& test, const Eigen::Vector3d& center, double size, const Budget& budget);

  ContainmentResult run();

  static constexpr std::size_t BATCH = 8;

  /// A part of the path at every scale of a range.
  struct Part
  {
    PathTree::Part path;
    double low;
    double high;
    /// Whether its points are proved to be good when they are moved by the generous reach, as others rely on it.
    bool is_relied_on = false;
  };
  using Parts = std::vector<Part>;
  /// A box that holds all that the parts have in another one which holds this one.
  struct Node
  {
    Box box;
    std::shared_ptr<const Parts> parts;
  };

  std::int64_t looks() const { return result_.boxes; }
  std::size_t waveSize() const;
  bool expand(const std::vector<Node>& nodes);

private:
  static Box nowhere() { return { Eigen::Vector3d::Constant(INF), Eigen::Vector3d::Constant(-INF) }; }

  /// What parts have in a box.
  struct Gathering
  {
    Box within;
    Parts kept = {};
    Box hull = nowhere();   ///< of all that they have there
    Box cover = nowhere();  ///< all of it are points that one of them is moved to

    void keep(const Part& part, const Box& common)
    {
      kept.push_back(part);
      hull = { hull.lower.cwiseMin(common.lower), hull.upper.cwiseMax(common.upper) };
    }
  };
  /// Where the margin of the criterion is least of what was looked at.
  struct WorstPlace
  {
    double margin = INF;
    GrowingVector place = {};
  };
  /// A point of the path, and which share of a box it covers.
  struct Cover
  {
    Part point = {};
    double share = 0.0;
  };

  void open(const Box& within, const Parts& parts);
  Eigen::Vector3d nearestInSolid(const Box& box) const;
  bool isApart(const Box& box) const;
  void openSolid(const Box& within);
  bool refuteAtOutline();
  void look(const std::vector<GrowingVector>& places, WorstPlace& worst) const;
  bool isBad(const GrowingVector& place);
  bool isBadBeside(const GrowingVector& place);
  bool cover();
  double coverage(const Part& part, const Box& within) const;
  void seekCover(const Part& part, const Box& within, Cover& best) const;
  void gatherCovered(const Part* first, const Part* last, Gathering& into) const;
  bool isLine(const Part& part) const;
  double reachOf(const Part& part) const { return part.is_relied_on ? generous_ : reach_; }
  static bool isSamePoint(const Part& a, const Part& b);
  static bool isCovered(const Box& box, const Gathering& into);
  void gather(const Part& part, Gathering& into) const;
  bool isLarge(const Part& part, const Box& placed, const Box& within) const;
  static double half(double low, double high) { return 0.5 * low + 0.5 * high; }
  template <class Use>
  void halve(const Part& part, const Use& use) const;
  double sweepOf(const Part& part) const;
  Box placed(const Part& part) const;
  Box thickened(const Box& box, double reach) const;
  Box coveredBy(const Box& point) const;
  bool settle(const Node& node, BoxVerdict verdict, const AffineForm<double>& worst);
  bool settleRates(const Node& node);
  bool divide(const Box& box, const Parts& parts, const AffineForm<double>* worst = nullptr);
  bool findBad(const Node& node, const Eigen::Vector3d& target);
  Part nearestPart(const Parts& parts, const Eigen::Vector3d& target, double enough) const;
  std::optional<GrowingVector> placeNear(const Node& node, const Eigen::Vector3d& target) const;
  std::optional<GrowingVector> placeInSolid(const Eigen::Vector3d& target) const;
  GrowingVector placeTowards(const Eigen::Vector3d& point, const Eigen::Vector3d& target) const;
  void addTooFast(const Part& part, const Box& box, Parts& too_fast);
  double bend(const PathTree::Part& piece) const;
  BoxVerdict ratesOn(const PathTree::Part& part, const Box& box) const;

  const PathBody& body_;
  const BoxTest& test_;
  const Budget& limits_;
  const RunningBudget budget_;
  const PathTree& moves_;
  const Eigen::Vector3d center_;
  const double size_;
  const double reach_;           ///< how far points are moved along each axis [m]
  const double generous_;        ///< a little more
  const double most_;            ///< scale
  bool asks_for_rates_ = false;  ///< in place of the criterion
  DepthFirst<Node> open_;
  ContainmentResult result_;
};
template <class Use>
void PathBody::Proof::halve(const Part& part, const Use& use) const
{
  if (sweepOf(part) > part.high * moves_.box(part.path).maxWidth())
  {
    const double middle = half(part.low, part.high);
    use(Part{ part.path, part.low, middle, part.is_relied_on });
    use(Part{ part.path, middle, part.high, part.is_relied_on });
  }
  else
    moves_.divide(part.path, [&](const PathTree::Part& path) {
      use(Part{ path, part.low, part.high, part.is_relied_on });
    });
}
}  // namespace pkm_workspace
