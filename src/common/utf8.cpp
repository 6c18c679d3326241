// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/common/utf8.h"

namespace pkm_workspace
{
namespace
{
/// Number of bytes of the UTF-8 character at the begin of @p text that XML allows, or 0.
std::size_t characterLength(const unsigned char* text)
{
  if (*text < 0x80)
    return *text >= 0x20 || *text == '\t' || *text == '\n' || *text == '\r' ? 1 : 0;
  const std::size_t length = *text >= 0xF0 ? 4 : *text >= 0xE0 ? 3 : 2;
  if (*text < 0xC2 || *text > 0xF4)
    return 0;
  for (std::size_t i = 1; i < length; ++i)
    if (text[i] < 0x80 || text[i] > 0xBF)
      return 0;
  return length;
}
}  // namespace

std::optional<int> unprintableByte(const std::string& text)
{
  const auto* const bytes = reinterpret_cast<const unsigned char*>(text.c_str());
  for (std::size_t i = 0; i < text.size();)
  {
    const std::size_t length = characterLength(bytes + i);
    if (length == 0)
      return bytes[i];
    i += length;
  }
  return std::nullopt;
}
}  // namespace pkm_workspace
