// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pkm_workspace/common/branch_and_bound.h"
#include "pkm_workspace/common/parallel.h"
#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/interval/running_bracket.h"
#include "pkm_workspace/region/center_space.h"
#include "pkm_workspace/region/center_test.h"
#include "pkm_workspace/region/incumbent.h"
#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/region/local_search.h"

namespace pkm_workspace
{
/// Branch and bound over the centers of a region, best upper bound first (docs/theory.md, the largest region). Boxes
/// are looked at in waves of a fixed number, so that the answer does not depend on the number of threads.
///
/// Invariant: every center that may carry a region larger than excluded_bound_ lies in an open box, and no center
/// of an open box carries one larger than that box's bound. The incumbent is certified.
class CenterSearch : private BranchingDefaults
{
public:
  /// @param known only regions larger than this are looked for; where there is none, the size found is 0
  /// @param verification_boxes most boxes that proofs of regions may take, all together; 0 = no limit
  /// @throws std::invalid_argument when the centers or the size are unbounded
  CenterSearch(const Machine& machine, const RegionQuery& query, double known = 0.0,
               std::int64_t verification_boxes = 0);

  /// Points that may be bad, from searches for like machines [m]: those that are proved to be bad are learnt.
  void suspect(const std::vector<Eigen::Vector3d>& points);
  /// Points that are proved to violate the criterion, as far as they are kept [m].
  const std::vector<Eigen::Vector3d>& badPoints() const { return witnesses_.bad(); }

  /// Runs to the end or to the budget. Everything is filled in but the joint ranges.
  LargestRegion run();

private:
  template <class Open, class Search, class Limits>
  friend Ending branchAndBound(Open& open, Search& search, const Limits& limits);

  struct Node
  {
    Box centers;
    double bound;           ///< certified: no center of the box carries a larger region
    double room;            ///< of the parent: among equal bounds the roomiest is first
    Interval angles = 0.0;  ///< by which the region is turned [rad]
    bool operator<(const Node& other) const
    {
      return bound < other.bound || (bound == other.bound && room < other.room);
    }
  };

  /// What a thread finds out about a box without touching anything shared.
  struct Look
  {
    double size = 0.0;                ///< that the box was asked about
    std::optional<Closing> excluded;  ///< at that size, and why
    double bound = 0.0;               ///< the node's, or the middle between it and the target if that was proved
    double room = 0.0;
    Reason reason{};  ///< of what was excluded, if reasons are kept
  };

  void start();
  void climbFrom(const Candidate& start);
  const BoxTest& testOfCenters() const;
  const BoxTest& testOfClimbs() const;
  Candidate settled(const Candidate& candidate) const;
  Candidate searched(const Candidate& candidate) const;
  ContainmentResult certify(const Candidate& candidate);
  void learn(const Candidate& refused, const ContainmentResult& proof);
  bool certifyBelow(const Candidate& candidate);
  bool expand(const std::vector<Node>& wave);
  Look lookAt(const Node& node, double size, CenterTest& center_test) const;
  Look ask(const Node& node, double size, CenterTest& center_test) const;
  double sweepOf(const Node& node) const;
  bool dividesAngles(const Node& node) const;
  void divide(const Node& node, const Look& look);
  bool tellsReasons() const { return query_.closed && !query_.turns(); }
  bool isNarrow(const Node& node) const;
  void settle(const Node& node, const Look& look);
  void noteLowered(const Reason& reason);
  void close(const Node& node, Reason reason) const;
  void grow();
  void tryCenter(const Node& node, double size);
  std::int64_t looks() const { return boxes_; }
  std::size_t waveSize() const;
  static std::size_t bytes(std::size_t open);
  void tellProgress();
  void lowerBounds();
  double target() const;
  double upperBound() const;
  LargestRegion result(Ending ending);

  const RegionQuery& query_;
  const RunningBudget budget_;
  BoxTest test_;
  CenterSpace space_;
  std::optional<BoxTest> test_across_rails_;  ///< where centers have places: the criterion without joint limits
  const RailTravel* travel_;                  ///< where it binds, or nullptr
  WitnessPoints witnesses_;
  std::vector<CenterTest> center_tests_;  ///< one for each box of a wave
  LocalSearch local_search_;
  ThreadPool pool_;
  double scale_;     ///< the longest strut [m]
  double accuracy_;  ///< the query's, or the finest that doubles are tried at
  Incumbent incumbent_;
  double excluded_bound_ = 0.0;   ///< no center in an excluded box carries a larger region
  double unsettled_bound_ = 0.0;  ///< the same for boxes that doubles cannot divide further
  BestFirst<Node> open_;
  /// Why bounds of boxes were lowered: only where somebody wants to know.
  std::vector<Reason> lowered_;
  std::int64_t boxes_ = 0;
  const bool is_part_;       ///< of a search over machines, which ends it soon
  std::int64_t checkpoint_;  ///< boxes after which the bounds of open boxes are lowered next
  RunningBracket bracket_;   ///< of the size
  Pace pace_;
  Eigen::Vector3d zero_;
};
}  // namespace pkm_workspace
