// SPDX-License-Identifier: BSD-3-Clause
#include "list_search.h"
#include "pkm_workspace/region/containment.h"
#include "problem.h"
#include "rows.h"

namespace pkm_workspace
{
namespace bench
{
namespace
{
constexpr double EDGE = 0.6439;  // [m]
constexpr std::int64_t MAX_BOXES = 10000000;
const Eigen::Vector3d CENTER = Eigen::Vector3d::Constant(0.086273015);

/// @param verify gives the boxes looked at, 0 when the cube is not proved
void addWay(const std::string& way, const std::function<std::int64_t()>& verify)
{
  addRow("Orthoglide, M on the cube of edge 0.6439", "", way, 3, [verify](benchmark::State& state) {
    std::int64_t boxes = 0;
    for (auto _ : state)
      boxes = verify();
    if (boxes == 0)
      state.SkipWithError("not proved within 10 million boxes");
    state.counters["points"] = static_cast<double>(boxes);
  })->UseRealTime();
}

std::int64_t verifyByPaper(const BoxClassifier& classify, const Box& cube)
{
  std::int64_t looks = 0;
  const BoxClassifier counting = [&](const Box& box) {
    ++looks;
    return classify(box);
  };
  return verifyBox(counting, cube, 1e-9, MAX_BOXES) == Share::ALL ? looks : 0;
}
}  // namespace

void addVerificationRows()
{
  const Machine machine = orthoglideCube().machine;
  const ShapePtr shape = makeCube();
  const Box cube = shape->boundingBox(CENTER, EDGE);
  addWay(OURS, [test = BoxTest(machine, Criterion()), shape] {
    const ContainmentResult result = checkContainment(test, *shape, CENTER, EDGE, MAX_BOXES);
    return result.verdict == Containment::INSIDE ? result.boxes : 0;
  });
  for (const auto& [way, classify] : paperTests(machine))
    addWay(way, [classify = classify, cube] { return verifyByPaper(classify, cube); });
  addWay("list, Boost.Interval, eigenvalues", [=] { return verifyByList(ListWay::EIGENVALUES, machine, cube); });
  addWay("list, Boost.Interval, minors", [=] { return verifyByList(ListWay::MINORS, machine, cube); });
}
}  // namespace bench
}  // namespace pkm_workspace
