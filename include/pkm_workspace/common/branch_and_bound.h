// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "pkm_workspace/common/budget.h"

namespace pkm_workspace
{
/// Why a node of a search is open no more.
enum class Closing
{
  FORM,         ///< a form that cannot be negative where anything is found is negative all over it
  COMBINATION,  ///< a combination of such forms, with weights >= 0, is negative all over it
  BAD_POINT,    ///< all that it holds contains a point that is proved to be bad
  BOUND,        ///< it holds nothing better than what is known
  UNSETTLED     ///< it is too small to be divided: nothing is proved of it
};

/// Is told each node that is closed, in an order that depends on no thread, and why.
template <class Node, class Reason = Closing>
using ProofLog = std::function<void(const Node&, const Reason&)>;

/// How a search ended.
enum class Ending
{
  EXHAUSTED,    ///< no node is open
  SETTLED,      ///< those that are open do not matter
  INDIVISIBLE,  ///< the next one cannot be divided
  BUDGET,       ///< a limit of boxes or of time, or the stop flag
  MEMORY        ///< one more wave may not fit into it
};

/// Open nodes, the best one first: the largest by operator<.
template <class T>
class BestFirst
{
public:
  using Node = T;

  bool isEmpty() const { return nodes_.empty(); }
  std::size_t size() const { return nodes_.size(); }
  const Node& first() const { return nodes_.front(); }
  /// All of them, the best one first, the others in no order.
  const std::vector<Node>& all() const { return nodes_; }
  void put(const Node& node)
  {
    nodes_.push_back(node);
    std::push_heap(nodes_.begin(), nodes_.end());
  }
  Node take()
  {
    std::pop_heap(nodes_.begin(), nodes_.end());
    Node node = std::move(nodes_.back());
    nodes_.pop_back();
    return node;
  }

private:
  std::vector<Node> nodes_;
};

/// Open nodes, the latest one first.
template <class T>
class DepthFirst
{
public:
  using Node = T;

  bool isEmpty() const { return nodes_.empty(); }
  std::size_t size() const { return nodes_.size(); }
  const Node& first() const { return nodes_.back(); }
  void put(const Node& node) { nodes_.push_back(node); }
  Node take()
  {
    Node node = std::move(nodes_.back());
    nodes_.pop_back();
    return node;
  }

private:
  std::vector<Node> nodes_;
};

/// What a search by branch and bound may tell branchAndBound(); these are the answers of the simplest one. It shadows
/// those that are different, and defines
///   bool expand(const std::vector<Node>& wave)  looks at the nodes, puts their parts into the open ones or closes
///                                               them; @return whether to go on
///   std::int64_t looks() const                  how many boxes it has looked at
struct BranchingDefaults
{
  /// So many waves go by from one look at the clock to the next.
  static constexpr std::int64_t WAVES_A_LOOK = 1;

  void tellProgress() const {}
  /// Whether the open nodes matter no more.
  bool isSettled() const { return false; }
  /// The most nodes that are looked at side by side next; 0 where that is settled.
  std::size_t waveSize() const { return 1; }
  /// Whether the node, the first of the open ones, is large enough to be divided.
  template <class Node>
  bool isDivisible(const Node& /*node*/) const
  {
    return true;
  }
  /// Memory that so many open nodes, and the parts of one more wave, may take [bytes].
  std::size_t bytes(std::size_t /*open*/) const { return 0; }
};

/// The one loop of all searches that divide: takes open nodes, wave by wave, and has the search expand them, until none
/// is open or something ends it. What is open then stays open.
/// @param limits a RunningBudget, or what answers the same questions
template <class Open, class Search, class Limits>
Ending branchAndBound(Open& open, Search& search, const Limits& limits)
{
  std::vector<typename Open::Node> wave;
  for (std::int64_t waves = 0; !open.isEmpty(); ++waves)
  {
    search.tellProgress();
    if (search.isSettled())
      return Ending::SETTLED;
    if (limits.hasSpent(search.looks()) || (waves % Search::WAVES_A_LOOK == 0 && limits.isOver()))
      return Ending::BUDGET;
    if (limits.isFull(search.bytes(open.size())))
      return Ending::MEMORY;
    const std::size_t most = std::min(search.waveSize(), open.size());
    if (most == 0)
      return Ending::SETTLED;
    wave.clear();
    while (wave.size() < most && search.isDivisible(open.first()))
      wave.push_back(open.take());
    if (wave.empty())
      return Ending::INDIVISIBLE;
    if (!search.expand(wave))
      return Ending::SETTLED;
  }
  return Ending::EXHAUSTED;
}
}  // namespace pkm_workspace
