// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <queue>
#include <vector>

#include "pkm_workspace/interval/box.h"
#include "support/definition.h"

namespace pkm_workspace
{
namespace test
{
/// Good points of a grid, by the definition, and which of them steps to next ones join whose middles are good.
class Flood
{
public:
  Flood(const Machine& machine, const Criterion& criterion, const Box& box, int steps)
    : machine_(machine), criterion_(criterion), box_(box), steps_(steps), labels_(size(), UNKNOWN)
  {
    for (std::size_t first = 0; first < size(); ++first)
      if (labels_[first] == UNKNOWN && isGood(first))
        spread(first);
  }

  std::size_t size() const { return static_cast<std::size_t>((steps_ + 1) * (steps_ + 1) * (steps_ + 1)); }
  /// -1 for a bad one.
  int label(std::size_t k) const { return labels_[k]; }

  Eigen::Vector3d point(std::size_t k) const
  {
    const int n = steps_ + 1;
    const auto at = static_cast<int>(k);
    const Eigen::Vector3d share(at % n, at / n % n, at / n / n);
    return box_.lower + (share / steps_).cwiseProduct(box_.upper - box_.lower);
  }

private:
  static constexpr int UNKNOWN = -2;

  bool isGood(const Eigen::Vector3d& point) const { return violatedAt(machine_, criterion_, point).empty(); }
  bool isGood(std::size_t k)
  {
    if (labels_[k] == UNKNOWN && !isGood(point(k)))
      labels_[k] = -1;
    return labels_[k] != -1;
  }

  void spread(std::size_t first)
  {
    const std::ptrdiff_t n = steps_ + 1;
    labels_[first] = next_;
    for (std::queue<std::size_t> open({ first }); !open.empty(); open.pop())
      for (const std::ptrdiff_t step : { std::ptrdiff_t(1), n, n * n })
        for (const std::ptrdiff_t sign : { -1, 1 })
        {
          const std::size_t here = open.front();
          const std::ptrdiff_t place = static_cast<std::ptrdiff_t>(here) / step % n + sign;
          if (place < 0 || place >= n)
            continue;
          const auto there = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(here) + sign * step);
          if (labels_[there] != UNKNOWN || !isGood(there) ||
              !isGood(Eigen::Vector3d(0.5 * (point(here) + point(there)))))
            continue;
          labels_[there] = next_;
          open.push(there);
        }
    ++next_;
  }

  Machine machine_;
  Criterion criterion_;
  Box box_;
  int steps_;
  std::vector<int> labels_;
  int next_ = 0;
};
}  // namespace test
}  // namespace pkm_workspace
