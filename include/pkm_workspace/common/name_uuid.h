// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <string>

namespace pkm_workspace
{
/// A name for exactly these bytes: a UUID (version 5, of the namespace of object identifiers).
inline std::string nameUuid(const std::string& bytes)
{
  return to_string(boost::uuids::name_generator_sha1(boost::uuids::ns::oid())(bytes));
}
}  // namespace pkm_workspace
