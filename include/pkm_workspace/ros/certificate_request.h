// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <memory>
#include <string>

#include "pkm_workspace/certificate/certificate_file.h"
#include "pkm_workspace/ros/parameters.h"

namespace pkm_workspace
{
/// The certificate that a request names.
/// @throws std::invalid_argument for a name that is not plain, and where the node has no folder for certificates
std::shared_ptr<CertificateFile> certificateFile(const std::string& name, const Parameters& parameters);

/// Saves it, and says in the answer what became of it: an answer is not lost for its certificate.
/// @param answer as CertificateFile::save() takes it
template <class Message, class... Answer>
void saveCertificate(const CertificateFile& file, Message& message, const Answer&... answer)
{
  try
  {
    message.certificate_message = file.save(answer...);
    message.certificate = file.path();
  }
  catch (const std::exception& error)
  {
    message.certificate_message = std::string("no certificate was written: ") + error.what();
  }
}
}  // namespace pkm_workspace
