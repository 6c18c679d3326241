// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iostream>
#include <string>

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

  /// Says on the error stream what the certificate does not claim.
  template <class... Answer>
  void save(const Answer&... answer) const
  {
    const std::string left_out = CertificateFile::save(answer...);
    if (!left_out.empty())
      std::cerr << "pkm: note: " << left_out << std::endl;
  }
};
}  // namespace cli
}  // namespace pkm_workspace
