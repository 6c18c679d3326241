// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reading.h"

namespace pkm_workspace
{
namespace firmware
{
/// What LinuxCNC's HAL files set of one component: by setp, or by sets and net on a signal.
class HalPins
{
public:
  /// @param prefix of the pins: "lineardeltakins."
  explicit HalPins(const std::string& prefix) : prefix_(prefix) {}

  void read(const std::vector<SourceLine>& lines);
  /// Values by pin, as the files have them.
  std::vector<Entry> values() const;

private:
  void readCommand(const std::vector<std::string>& words, const SourcePlace& place);

  std::string prefix_;
  std::vector<Entry> set_;                     ///< pins
  std::vector<Entry> signals_;                 ///< values of signals
  std::map<std::string, std::string> driven_;  ///< pins, and the signal of each
};
}  // namespace firmware
}  // namespace pkm_workspace
