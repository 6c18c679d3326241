// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <mutex>

#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/ros/node_context.h"
#include "pkm_workspace/ros/set_picture.h"

namespace pkm_workspace
{
/// Makes the smooth surfaces of sets, which takes seconds, while others show their boxes. Thread-safe.
class SurfaceMaker
{
public:
  using Show = std::function<void(const std::shared_ptr<const SetPicture>&)>;

  /// @param context has to outlive this object, its threads have to end before
  explicit SurfaceMaker(NodeContext& context) : context_(context) {}

  /// Has the painter show the surface of a set, once it is made, unless boxes are what is to be shown. Gives up what
  /// was asked for before. Where there will be none, the log says why.
  /// @param in the machine of the paving @param with_outer whether what is undecided is to be shown
  void make(const FramedMachine& in, const std::shared_ptr<const Paving>& paving, bool with_outer, const Show& show);

private:
  std::shared_ptr<const SetPicture> surfaceOf(const Machine& machine, const Paving& paving, bool with_outer,
                                              const StopFlag& stop) const;

  NodeContext& context_;
  std::mutex mutex_;
  StopFlag last_ = std::make_shared<std::atomic<bool>>(false);
};
}  // namespace pkm_workspace
