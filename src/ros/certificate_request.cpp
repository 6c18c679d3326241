// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/certificate_request.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace pkm_workspace
{
namespace
{
constexpr std::size_t LONGEST_NAME = 100;

/// In ASCII, whatever the locale.
bool isPlain(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
}
}  // namespace

std::shared_ptr<CertificateFile> certificateFile(const std::string& name, const Parameters& parameters)
{
  if (name.empty())
    return std::make_shared<CertificateFile>();
  if (name.size() > LONGEST_NAME || name.front() == '.' || !std::all_of(name.begin(), name.end(), isPlain))
    throw std::invalid_argument("certificate = '" + name +
                                "' must be the plain name of a file, at most 100 letters, digits, '.', '_' and '-', "
                                "the first one no '.'");
  if (parameters.certificate_folder.empty())
    throw std::invalid_argument("certificate = '" + name +
                                "': this node writes no certificates; its parameter ~certificate_folder names the "
                                "folder that they go to");
  const std::string path = parameters.certificate_folder + "/" + name;
  std::error_code error;
  if (std::filesystem::is_symlink(path, error))
    throw std::invalid_argument("certificate = '" + name +
                                "': there is a symbolic link of that name, which is not followed");
  return std::make_shared<CertificateFile>(path);
}
}  // namespace pkm_workspace
