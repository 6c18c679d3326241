// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/region/path.h"
#include "pkm_workspace/region/reason.h"

namespace pkm_workspace
{
// Files that show others why an answer is true (docs/certificate.md): the machine, what is asked of it, the claims, and
// for each box of their proofs the reason.

/// Appends one sentence for everything that certificates do not know yet.
/// @param shape of the region that it is about, or nullptr
void validateCertificate(const Machine& machine, const Criterion& criterion, const Shape* shape, Problems& problems);
/// The same of a search for the largest region.
void validateCertificate(const Machine& machine, const RegionQuery& query, Problems& problems);

/// Writes down why boxes of centers are closed while a search for the largest region runs.
class SearchRecord
{
public:
  /// What reasons say, without the forms: see ReasonTerm.
  struct Term
  {
    std::size_t place = 0;  ///< number of a point of the body or, of BAD_POINT, of a bad point
    ReasonTerm::Kind kind = ReasonTerm::Kind::CONDITION;
    Subject subject = { ConditionKind::REACH };
    std::array<double, 3> v{};
    double weight = 1.0;
  };
  struct Leaf
  {
    bool is_proved = false;  ///< for a reason that somebody else can check
    double size = 0.0;
    std::vector<Term> terms;
  };
  /// Doubles that tell a box or a place from all others.
  using Key = std::array<double, 6>;

  /// Follows the query's search for a machine. Keeps this object's address: it must outlive the search.
  void follow(const Machine& machine, RegionQuery& query);

  const std::map<Key, Leaf>& leaves() const { return leaves_; }
  const std::vector<GrowingVector>& points() const { return points_; }
  const std::vector<Eigen::Vector3d>& badPoints() const { return bad_; }

private:
  void close(const Box& centers, const Reason& reason);
  Term termOf(const ReasonTerm& term);

  std::map<Key, Leaf> leaves_;
  std::map<Key, std::size_t> point_numbers_;
  std::map<Key, std::size_t> bad_numbers_;
  std::vector<GrowingVector> points_;
  std::vector<Eigen::Vector3d> bad_;
};

/// A certificate, and what of the answer it does not claim.
struct RegionCertificate
{
  std::string json;
  std::string left_out;  ///< one sentence; empty where it claims all
};

/// The certificate of a region, and of the bound above it as far as there are reasons for that.
/// @param record of the search that found it
/// @throws std::invalid_argument as validateCertificate(), or where the region cannot be proved once more
RegionCertificate certificateOf(const Machine& machine, const RegionQuery& query, const LargestRegion& region,
                                const SearchRecord& record);
/// The certificate of a paving: which boxes are proved to be inside, and which outside.
std::string certificateOf(const Machine& machine, const Criterion& criterion, const Paving& paving);
/// The certificate of a path of straight segments that is inside.
/// @throws std::invalid_argument as validateCertificate(), for an arc, or where a segment cannot be proved once more
std::string certificateOf(const Machine& machine, const Criterion& criterion, const std::vector<PathSegment>& path);
/// The certificate of a region that is proved: c + K(size) satisfies the criterion.
std::string certificateOf(const Machine& machine, const Criterion& criterion, const Shape& shape,
                          const Eigen::Vector3d& center, double size);
}  // namespace pkm_workspace
