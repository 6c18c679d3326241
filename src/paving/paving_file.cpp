// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/paving_file.h"

#include <algorithm>
#include <boost/crc.hpp>
#include <stdexcept>

#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/version.h"

namespace pkm_workspace
{
namespace
{
// In order: magic, format, size of the file, version of the library, number of pavings; each paving: its premises
// (geometry hash, criterion), resolution, box, its tree with one byte a box; last, the checksum of all before it.
const std::string MAGIC = "PKM paving\n";
// Format 2 has five bounds; each more is another format.
constexpr std::uint32_t FORMAT = 2;
constexpr std::size_t CHECKSUM_BYTES = sizeof(std::uint32_t);

/// CRC-32 of the first bytes.
std::uint32_t checksum(const std::string& bytes, std::size_t size)
{
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), size);
  return crc.checksum();
}

void put(const Paving& paving, ByteWriter& writer)
{
  put(paving.premises, writer);
  writer.real(paving.resolution);
  for (const Eigen::Vector3d* corner : { &paving.box.lower, &paving.box.upper })
    for (int axis = 0; axis < 3; ++axis)
      writer.real((*corner)[axis]);
  for (std::size_t level = 0; level < paving.tree.levels(); ++level)
    writer.raw(paving.tree.level(level).data(), paving.tree.level(level).size());
}

/// Adds the next level. @return how many boxes the level after it has
std::size_t takeLevel(std::size_t size, BoxTree& tree, ByteReader& reader)
{
  const bool last = tree.levels() == tree.bisection().depth();
  const char* const data = reader.raw(size);
  std::vector<CellState> states(size);
  for (std::size_t k = 0; k < size; ++k)
  {
    states[k] = static_cast<CellState>(data[k]);
    if (states[k] > CellState::PENDING || states[k] == (last ? CellState::SPLIT : CellState::BOUNDARY))
      throw std::runtime_error("box " + std::to_string(k) + " of level " + std::to_string(tree.levels()) +
                               " has a state that is not possible there");
  }
  tree.addLevel(std::move(states));
  return 2 * static_cast<std::size_t>(tree.count(CellState::SPLIT, tree.levels() - 1));
}

/// @throws std::runtime_error, or std::invalid_argument for numbers that nobody can pave with
Paving takePaving(ByteReader& reader)
{
  Paving paving;
  paving.premises = takePremises(reader);
  paving.resolution = reader.real();
  for (Eigen::Vector3d* corner : { &paving.box.lower, &paving.box.upper })
    for (int axis = 0; axis < 3; ++axis)
      (*corner)[axis] = reader.real();
  Problems problems;
  paving.premises.criterion.validate(problems);
  validatePositive("resolution", paving.resolution, "m", problems);
  const bool has_boxes = paving.box.isValid();
  if (has_boxes)
    validateBox("box", paving.box, problems);
  throwProblems(problems);
  if (has_boxes)
  {
    paving.tree = BoxTree(Bisection(paving.box, paving.resolution));
    for (std::size_t size = 1; size > 0;)
      size = takeLevel(size, paving.tree, reader);
  }
  paving.sumUp();
  return paving;
}

/// @throws std::runtime_error with the reason
void checkWhole(const std::string& bytes)
{
  if (bytes.compare(0, MAGIC.size(), MAGIC) != 0)
    throw std::runtime_error("it is not a paving of this program");
  ByteReader reader(bytes, bytes.size());
  reader.raw(MAGIC.size());
  const auto format = reader.number<std::uint32_t>();
  if (format != FORMAT)
    throw std::runtime_error("it is of format " + std::to_string(format) + ", this program reads format " +
                             std::to_string(FORMAT));
  const auto size = reader.number<std::uint64_t>();
  if (size != bytes.size() || reader.left() < CHECKSUM_BYTES)
    throw std::runtime_error("it has " + std::to_string(bytes.size()) + " bytes instead of " + std::to_string(size) +
                             ": it was cut or added to");
  reader.raw(reader.left() - CHECKSUM_BYTES);
  if (reader.number<std::uint32_t>() != checksum(bytes, bytes.size() - CHECKSUM_BYTES))
    throw std::runtime_error("its checksum does not fit: it was altered");
}

std::vector<Paving> takeAll(const std::string& bytes)
{
  checkWhole(bytes);
  ByteReader reader(bytes, bytes.size() - CHECKSUM_BYTES);
  reader.raw(MAGIC.size() + sizeof(std::uint32_t) + sizeof(std::uint64_t));
  const std::string writer = reader.text();
  if (writer != version())
    throw std::runtime_error("version " + writer + " wrote it, this is version " + version() +
                             ", whose boxes may be others");
  std::vector<Paving> pavings;
  for (auto count = reader.number<std::uint32_t>(); count > 0; --count)
    pavings.push_back(takePaving(reader));
  if (reader.left() > 0)
    throw std::runtime_error(std::to_string(reader.left()) + " bytes are left over");
  return pavings;
}

void checkSubject(const std::vector<Paving>& pavings, const Machine& machine, const std::vector<PavingQuery>& queries)
{
  Problems problems;
  for (std::size_t k = 0; k < std::min(pavings.size(), queries.size()) && problems.empty(); ++k)
    validateEarlier(machine, queries[k], pavings[k], problems);  // what is wrong is so with all of them
  if (problems.empty() && pavings.size() != queries.size())
    problems.push_back("it holds " + std::to_string(pavings.size()) + " pavings, asked for are " +
                       std::to_string(queries.size()));
  throwProblems(problems);
}
}  // namespace

void savePavings(const std::string& path, const std::vector<Paving>& pavings)
{
  ByteWriter body;
  body.text(version());
  body.number(static_cast<std::uint32_t>(pavings.size()));
  for (const Paving& paving : pavings)
    put(paving, body);
  ByteWriter file;
  file.raw(MAGIC.data(), MAGIC.size());
  file.number(FORMAT);
  file.number(
      static_cast<std::uint64_t>(file.bytes().size() + sizeof(std::uint64_t) + body.bytes().size() + CHECKSUM_BYTES));
  file.raw(body.bytes().data(), body.bytes().size());
  file.number(checksum(file.bytes(), file.bytes().size()));
  writeWholeFile(path, file.bytes());
}

std::vector<Paving> loadPavings(const std::string& path, const Machine& machine,
                                const std::vector<PavingQuery>& queries)
{
  const std::string bytes = readWholeFile(path, std::string().max_size());
  try
  {
    std::vector<Paving> pavings = takeAll(bytes);
    for (Paving& paving : pavings)
      if (paving.premises.geometry_hash == machine.geometryHash())
        paving.premises = premisesOf(machine, paving.premises.criterion);  // files may tell of limits that it lacks
    checkSubject(pavings, machine, queries);
    return pavings;
  }
  catch (const std::exception& reason)
  {
    throw std::invalid_argument(path + ": the paving is refused: " + reason.what());
  }
}
}  // namespace pkm_workspace
