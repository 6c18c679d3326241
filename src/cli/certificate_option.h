// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "caller.h"
#include "common_options.h"
#include "pkm_workspace/certificate/certificate_file.h"

namespace pkm_workspace
{
namespace cli
{
/// A file that shows others why the answer is true.
class CertificateOption : public CertificateFile
{
public:
  void declare(Options& options)
  {
    declareOutput(options, "certificate", path_,
                  "file for the reasons of every step of the proof, for pkm verify and other checkers; a file there is "
                  "replaced");
  }

  /// Notes what the certificate does not claim.
  template <class... Answer>
  void save(Caller& caller, const Answer&... answer) const
  {
    const std::string left_out = CertificateFile::save(answer...);
    if (!left_out.empty())
      caller.note(left_out);
  }
};
}  // namespace cli
}  // namespace pkm_workspace
