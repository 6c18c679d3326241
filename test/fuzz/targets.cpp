// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/targets.h"

#include <cstdlib>
#include <iostream>
#include <stdexcept>

namespace pkm_workspace
{
namespace test
{
void demand(bool holds, const char* property)
{
  if (holds)
    return;
  std::cerr << "does not hold: " << property << std::endl;
  std::abort();
}

bool isAccepted(const std::function<void()>& read)
{
  try
  {
    read();
    return true;
  }
  catch (const std::invalid_argument& refusal)
  {
    demand(*refusal.what() != '\0', "a refusal has a reason");
    return false;
  }
}

const FuzzTarget& fuzzTarget(const std::string& name)
{
  for (const FuzzTarget& target : FUZZ_TARGETS)
    if (name == target.name)
      return target;
  std::cerr << "'" << name << "' is none of:";
  for (const FuzzTarget& target : FUZZ_TARGETS)
    std::cerr << " " << target.name;
  std::cerr << std::endl;
  std::exit(2);
}
}  // namespace test
}  // namespace pkm_workspace
