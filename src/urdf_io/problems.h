// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include "pkm_workspace/interval/text_stream.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// Collects what is wrong with an input, one line for each, to tell it all at once.
class Problems
{
public:
  /// Begins a line and returns the stream to write it to.
  std::ostream& add() { return text_ << "\n  "; }
  bool any() const { return !text_.str().empty(); }
  void throwIfAny() const
  {
    if (any())
      throw std::invalid_argument("the URDF is refused:" + text_.str());
  }

private:
  TextStream text_;
};
}  // namespace urdf_io
}  // namespace pkm_workspace
