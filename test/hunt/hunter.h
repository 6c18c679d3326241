// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>

#include "hunt/body.h"
#include "hunt/subject.h"
#include "pkm_workspace/dexterity/verdict.h"

namespace pkm_workspace
{
namespace test
{
/// What was claimed, and the point that shows it wrong.
struct Contradiction : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// How often each claim was made and hunted.
using Tally = std::map<std::string, int>;

/// Hunts one subject: asks questions about it, and looks for points that contradict the answers. Candidates come from
/// random points and from descents of the margin in floating point, the library's own or, as somebody who forgets a
/// condition forgets it there too, blindly; the oracle decides on each of them in 100 digits.
class Hunter
{
public:
  Hunter(const Subject& subject, Random& random, Tally& tally);

  /// Verdicts on boxes of any size, most of them at the border of the set.
  void huntBoxes(int count);
  /// Verdicts on regions, with the bad points that they name.
  void huntContainments(int count);
  /// The largest region, and whether there is a larger one than its upper bound.
  void huntLargest();
  /// Lines, arcs and helices.
  void huntPaths(int count);
  /// The largest region that all machines within some tolerances have.
  void huntTolerances();

private:
  using Vector = Eigen::Vector3d;
  /// How good a region's or box's point at u is; u from -1 to 1.
  using Guide = std::function<double(const Vector& u)>;

  /// @throws Contradiction where the definition says otherwise
  void expectAt(const Vector& point, bool is_good, const std::string& claim) const;
  double margin(const Vector& point) const;
  Vector anyPoint();
  /// A point at the border of the set, up to rounding, or any where there is none at hand.
  Vector borderPoint();
  Vector corner();
  Vector anyOffset();
  /// Where the guide is least, near to the start.
  Vector descend(const Guide& guide, Vector from) const;
  /// Points that the region has, for certain: where its margin is least, at its surface, and any.
  void expectGoodRegion(const Body& body, const Vector& center, double size, const std::string& claim);
  void expectNoneLarger(Body body, const RegionQuery& query, const LargestRegion& found);
  bool isGoodRegion(const Body& body, const Vector& center, double size);
  RegionQuery drawnQuery(Body& body);

  Subject subject_;
  Random& random_;
  Tally& tally_;
  BoxTest test_;
  Oracle oracle_;
  double scale_;
};
}  // namespace test
}  // namespace pkm_workspace
