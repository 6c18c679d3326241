// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/certificate/certificate.h"

#include <stdexcept>

#include "certificate_json.h"
#include "pkm_workspace/region/center_space.h"

namespace pkm_workspace
{
using namespace certificate;

namespace
{
/// Boxes that the proof of a region may take when it is written down.
constexpr std::int64_t MOST_PARTS = 1000000;

/// Proves the region once more and writes down how.
std::string regionText(const BoxTest& test, const Shape& shape, const Eigen::Vector3d& center, double size)
{
  std::map<Key, std::pair<int, double>> cuts;
  Budget budget;
  budget.max_boxes = MOST_PARTS;
  const ContainmentResult proof =
      checkContainment(test, shape, center, size, budget, [&](const Box& part, int axis, double plane) {
        cuts[keyOf(part)] = { axis, plane };
      });
  if (proof.verdict != Containment::INSIDE)
    throw std::invalid_argument("the certificate cannot be written: the region is not proved once more");
  const Box box = shape.boundingBox(center, size);
  const auto cutOf = [&](const Box& part) {
    const auto cut = cuts.find(keyOf(part));
    return cut == cuts.end() ? std::nullopt : std::make_optional(cut->second);
  };
  const Json region{ { "center", toJson(center) }, { "size", size }, { "box", toJson(box) } };
  return withMember(region, "tree", treeText(box, cutOf, [](const Box&, std::string& text) { text += '0'; }));
}

void refuse(Problems& problems, bool is_asked, const char* what)
{
  if (is_asked)
    problems.push_back(std::string("certificates do not know ") + what + " yet: leave it out, or the certificate");
}
}  // namespace

void validateCertificate(const Machine& machine, const Criterion& criterion, const Shape* shape, Problems& problems)
{
  refuse(problems, shape != nullptr && (shape->isPolytope() || shape->ownProof() != nullptr), "regions of this shape");
  for (const Leg& leg : machine.legs())
    refuse(problems, std::holds_alternative<Crank>(leg.kind) && leg.limits.isBounded() && leg.limits.width() > 3.14,
           "cranks with limits of more than half a turn");
  refuse(problems, machine.hasTolerances(), "tolerances");
  refuse(problems, criterion.boundsCondition(), "the condition number");
  refuse(problems, criterion.boundsMore(), "conditions on speeds, forces, stiffness, errors or angles");
  refuse(problems, !criterion.zones.empty(), "zones");
}

void validateCertificate(const Machine& machine, const RegionQuery& query, Problems& problems)
{
  validateCertificate(machine, query.criterion, query.shape.get(), problems);
  refuse(problems, query.turns(), "turned regions");
  refuse(problems, query.ratio.has_value(), "cylinders of free ratio");
}

RegionCertificate certificateOf(const Machine& machine, const RegionQuery& query, const LargestRegion& region,
                                const SearchRecord& record)
{
  Problems problems;
  validateCertificate(machine, query, problems);
  throwProblems(problems);
  Claims claims;
  if (region.size > 0.0)
    claims["region"] =
        regionText(BoxTest(machine, query.criterion, query.precision), *region.shape, region.center, region.size);
  const Box centers = centerSpace(machine, query).centers;
  const auto bound = boundText(machine, query, record, centers, region.size_upper_bound);
  if (bound)
    claims["bound"] = *bound;
  if (claims.empty())
    throw std::invalid_argument("there is nothing to certify: no region, and no reasons that a checker knows");
  RegionCertificate certificate{ fileOf(machine, query.criterion, query.shape.get(), claims), "" };
  if (!bound)
    certificate.left_out =
        "the certificate has no bound: the search did not close all boxes, or for reasons that checkers do not know";
  return certificate;
}

std::string certificateOf(const Machine& machine, const Criterion& criterion, const Shape& shape,
                          const Eigen::Vector3d& center, double size)
{
  Problems problems;
  validateCertificate(machine, criterion, &shape, problems);
  throwProblems(problems);
  const BoxTest test(machine, criterion, Precision::MULTIPLE);
  return fileOf(machine, criterion, &shape, { { "region", regionText(test, shape, center, size) } });
}
}  // namespace pkm_workspace
