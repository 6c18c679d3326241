// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>

namespace pkm_workspace
{
namespace urdf_io
{
/// Collects what is wrong with an input, one line for each, to tell it all at once.
class Problems
{
public:
  Problems() { text_.imbue(std::locale::classic()); }

  /// Begins a line and returns the stream to write it to.
  std::ostream& add() { return text_ << "\n  "; }
  bool any() const { return !text_.str().empty(); }
  void throwIfAny() const
  {
    if (any())
      throw std::invalid_argument("the URDF is refused:" + text_.str());
  }

private:
  std::ostringstream text_;
};
}  // namespace urdf_io
}  // namespace pkm_workspace
