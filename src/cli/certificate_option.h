// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iostream>
#include <string>

#include "common_options.h"
#include "pkm_workspace/certificate/certificate.h"
#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/region/solid.h"

namespace pkm_workspace
{
namespace cli
{
/// A file that shows others why the answer is true.
class CertificateOption
{
public:
  void declare(Options& options)
  {
    declareOutput(options, "certificate", path_,
                  "file for the reasons of every step of the proof, for pkm verify and other checkers; a file there is "
                  "replaced");
  }
  bool given() const { return !path_.empty(); }

  /// @throws std::invalid_argument where there cannot be one
  void follow(const Machine& machine, RegionQuery& query)
  {
    if (!given())
      return;
    Problems problems;
    validateCertificate(machine, query, problems);
    throwProblems(problems);
    record_.follow(machine, query);
  }

  void save(const Machine& machine, const RegionQuery& query, const LargestRegion& region) const
  {
    if (!given())
      return;
    const RegionCertificate certificate = certificateOf(machine, query, region, record_);
    writeWholeFile(path_, certificate.json);
    if (!certificate.left_out.empty())
      std::cerr << "pkm: note: " << certificate.left_out << std::endl;
  }

  void save(const Machine& machine, const Criterion& criterion, const Solid& solid, const Eigen::Vector3d& center) const
  {
    if (given())
      writeWholeFile(path_, certificateOf(machine, criterion, *solid.shape, center, solid.size));
  }

  void save(const Machine& machine, const Criterion& criterion, const Paving& paving) const
  {
    if (given())
      writeWholeFile(path_, certificateOf(machine, criterion, paving));
  }

  void save(const Machine& machine, const Criterion& criterion, const std::vector<PathSegment>& path) const
  {
    if (given())
      writeWholeFile(path_, certificateOf(machine, criterion, path));
  }

  /// @throws std::invalid_argument where there cannot be one
  void validate(const Machine& machine, const Criterion& criterion) const
  {
    Problems problems;
    if (given())
      validateCertificate(machine, criterion, problems);
    throwProblems(problems);
  }

private:
  std::string path_;
  SearchRecord record_;
};
}  // namespace cli
}  // namespace pkm_workspace
