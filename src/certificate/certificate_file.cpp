// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/certificate/certificate_file.h"

#include <stdexcept>

#include "pkm_workspace/common/whole_file.h"

namespace pkm_workspace
{
namespace
{
/// Of a paving, at most, while it is written.
constexpr std::int64_t BYTES_A_BOX = 160;

void requireInside(Containment verdict, const std::string& what)
{
  if (verdict != Containment::INSIDE)
    throw std::invalid_argument("the verdict on the " + what + " is not INSIDE: there is nothing to certify");
}
}  // namespace

void CertificateFile::follow(const Machine& machine, RegionQuery& query)
{
  if (!given())
    return;
  Problems problems;
  validateCertificate(machine, query, problems);
  throwProblems(problems);
  record_.follow(machine, query);
}

void CertificateFile::validate(const Machine& machine, const Criterion& criterion, const Shape* shape) const
{
  Problems problems;
  if (given())
    validateCertificate(machine, criterion, shape, problems);
  throwProblems(problems);
}

std::string CertificateFile::save(const Machine& machine, const RegionQuery& query, const LargestRegion& region) const
{
  if (!given())
    return "";
  const RegionCertificate certificate = certificateOf(machine, query, region, record_);
  writeWholeFile(path_, certificate.json);
  return certificate.left_out;
}

std::string CertificateFile::save(const Machine& machine, const Criterion& criterion, Containment verdict,
                                  const Solid& solid, const Eigen::Vector3d& center) const
{
  if (!given())
    return "";
  requireInside(verdict, "region");
  writeWholeFile(path_, certificateOf(machine, criterion, *solid.shape, center, solid.size));
  return "";
}

std::string CertificateFile::save(const Machine& machine, const Criterion& criterion, const Paving& paving,
                                  std::int64_t max_memory) const
{
  if (!given())
    return "";
  if (paving.boxes > max_memory / BYTES_A_BOX)
    throw std::invalid_argument("the certificate of " + std::to_string(paving.boxes) + " boxes takes up to " +
                                std::to_string(paving.boxes * BYTES_A_BOX) + " bytes of memory, " +
                                std::to_string(max_memory) + " are allowed: ask for a coarser resolution");
  writeWholeFile(path_, certificateOf(machine, criterion, paving));
  return "";
}

std::string CertificateFile::save(const Machine& machine, const Criterion& criterion, Containment verdict,
                                  const std::vector<PathSegment>& path, bool is_at_speed) const
{
  if (!given())
    return "";
  requireInside(verdict, "path");
  writeWholeFile(path_, certificateOf(machine, criterion, path));
  return is_at_speed ? "the certificate is about the points of the path, not about the speeds of the joints" : "";
}
}  // namespace pkm_workspace
