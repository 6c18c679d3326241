// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/text_stream.h"

#include <algorithm>
#include <locale>

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
class ExactNumbers : public std::num_put<char>
{
protected:
  iter_type do_put(iter_type out, std::ios_base& format, char_type fill, double value) const override
  {
    const std::string text = exact(value);
    const auto size = static_cast<std::streamsize>(text.size());
    out = std::fill_n(out, std::max<std::streamsize>(0, format.width() - size), fill);
    format.width(0);
    return std::copy(text.begin(), text.end(), out);
  }
};
}  // namespace

TextStream::TextStream()
{
  static const std::locale plain(std::locale::classic(), new ExactNumbers);
  imbue(plain);
}
}  // namespace pkm_workspace
