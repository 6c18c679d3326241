// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pkm_workspace/certificate/certificate.h"
#include "pkm_workspace/region/solid.h"

namespace pkm_workspace
{
/// The file that the certificate of an answer goes to, where one is asked for. A file that is there is replaced, by a
/// whole one. Each save() does nothing where none is asked for.
/// @throws std::invalid_argument where there cannot be such a certificate, or such a file
class CertificateFile
{
public:
  /// @param path empty: none is asked for
  explicit CertificateFile(std::string path = "") : path_(std::move(path)) {}

  bool given() const { return !path_.empty(); }
  const std::string& path() const { return path_; }

  /// Before a search: records its reasons. Keeps this object's address: it must outlive the search.
  void follow(const Machine& machine, RegionQuery& query);
  /// Before any other computation.
  void validate(const Machine& machine, const Criterion& criterion, const Shape* shape = nullptr) const;

  /// Of the search that was followed. @return one sentence about what of the answer it does not claim, or nothing
  std::string save(const Machine& machine, const RegionQuery& query, const LargestRegion& region) const;
  /// Of the verdict on a solid region.
  std::string save(const Machine& machine, const Criterion& criterion, Containment verdict, const Solid& solid,
                   const Eigen::Vector3d& center) const;
  /// @param max_memory that it may take [bytes]: a box in writing takes more than one in memory
  std::string save(const Machine& machine, const Criterion& criterion, const Paving& paving,
                   std::int64_t max_memory) const;
  /// Of the verdict on a path. @param is_at_speed whether limits of joint speeds were part of it
  std::string save(const Machine& machine, const Criterion& criterion, Containment verdict,
                   const std::vector<PathSegment>& path, bool is_at_speed) const;

protected:
  std::string path_;

private:
  SearchRecord record_;
};
}  // namespace pkm_workspace
