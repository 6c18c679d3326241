// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <memory>
#include <stdexcept>
#include <string>

#include "pkm_workspace/certificate/certificate_file.h"
#include "pkm_workspace/ros/parameters.h"

namespace pkm_workspace
{
/// The certificate that a request names.
/// @throws std::invalid_argument for a name that is not plain, and where the node has no folder for certificates
std::shared_ptr<CertificateFile> certificateFile(const std::string& name, const Parameters& parameters);

/// Saves it, if one is asked for, and says in the answer what became of it: an answer is not lost for its certificate.
/// @param is_stopped whether whoever asked wants no more @param answer as CertificateFile::save() takes it
template <class Message, class... Answer>
void saveCertificate(const CertificateFile& file, bool is_stopped, Message& message, const Answer&... answer)
{
  if (!file.given())
    return;
  try
  {
    if (is_stopped)
      throw std::runtime_error("the computation was stopped");
    message.certificate_message = file.save(answer...);
    message.certificate = file.path();
  }
  catch (const std::exception& error)
  {
    message.certificate_message = std::string("no certificate was written: ") + error.what();
  }
}
}  // namespace pkm_workspace
