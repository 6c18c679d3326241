// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>

namespace pkm_workspace
{
/// Puts a text together: doubles in it are written by exact(), and nothing follows the locale.
class TextStream : public std::ostringstream
{
public:
  TextStream();
};
}  // namespace pkm_workspace
