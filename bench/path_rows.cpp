// SPDX-License-Identifier: BSD-3-Clause
#include "path_problem.h"
#include "pkm_workspace/region/path_check.h"
#include "problem.h"
#include "rows.h"

namespace pkm_workspace
{
namespace bench
{
namespace
{
constexpr std::size_t SEGMENTS = 10000;

/// @param make the segment from one point of the curve through the next to the one after that
template <class Make>
std::vector<PathSegment> segmentsOf(const Make& make)
{
  std::vector<PathSegment> segments;
  for (std::size_t i = 0; i < SEGMENTS; ++i)
  {
    const auto at = [i](double step) { return curve((static_cast<double>(i) + step) / SEGMENTS); };
    segments.push_back(make(at(0.0), at(0.5), at(1.0)));
  }
  return segments;
}

void addPath(const std::string& name, const std::vector<PathSegment>& segments)
{
  const PointEvaluator evaluator(orthoglideCube().machine, Criterion());
  addRow("Orthoglide, a path of 10^4 " + name, "", OURS, 5, [evaluator, segments](benchmark::State& state) {
    bool is_proved = false;
    std::int64_t looks = 0;
    for (auto _ : state)
    {
      const PathResult result = checkPath(evaluator, segments);
      is_proved = result.verdict == Containment::INSIDE;
      looks = result.looks;
    }
    if (!is_proved)
      state.SkipWithError("not proved");
    state.counters["points"] = static_cast<double>(looks);
  });
}
}  // namespace

void addPathRows()
{
  using Eigen::Vector3d;
  addPath("lines", segmentsOf([](const Vector3d& start, const Vector3d&, const Vector3d& end) {
            return PathSegment::line(start, end);
          }));
  addPath("arcs", segmentsOf([](const Vector3d& start, const Vector3d& via, const Vector3d& end) {
            return PathSegment::arcThrough(start, via, end);
          }));
  const PointEvaluator evaluator(orthoglideCube().machine, Criterion());
  addRow("Orthoglide, 10^4 points evaluated", "", OURS, 5, [evaluator](benchmark::State& state) {
    std::size_t good = 0;
    for (auto _ : state)
    {
      good = 0;
      for (std::size_t i = 0; i < SEGMENTS; ++i)
        good += evaluator(curve(static_cast<double>(i) / SEGMENTS)).verdict == BoxVerdict::INSIDE ? 1 : 0;
    }
    if (good != SEGMENTS)
      state.SkipWithError("not proved");
    state.counters["points"] = static_cast<double>(good);
  });
}
}  // namespace bench
}  // namespace pkm_workspace
