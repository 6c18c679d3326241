// SPDX-License-Identifier: BSD-3-Clause
// Hunts for contradictions in what the library proves; scripts/hunt runs it.
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "hunt/hunter.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
struct Hunt
{
  std::uint64_t seed = SEED;
  std::uint64_t first = 0;
  std::uint64_t cases = 0;  ///< 0: as many as there is time for
  double minutes = 0.0;
};

constexpr char USAGE[] = "usage: hunt [--seed S] [--first CASE] [--cases COUNT | --minutes M]\n";

Hunt huntOf(int argc, char** argv)
{
  Hunt hunt;
  for (int i = 1; i < argc; i += 2)
  {
    const std::string option = argv[i];
    char* end = nullptr;
    const double value = i + 1 < argc ? std::strtod(argv[i + 1], &end) : -1.0;
    if (end == nullptr || *end != '\0' || !(value >= 0.0 && value <= 1e9))
      throw std::invalid_argument(option + " needs a number from 0 to 1e9");
    if (option == "--seed")
      hunt.seed = static_cast<std::uint64_t>(value);
    else if (option == "--first")
      hunt.first = static_cast<std::uint64_t>(value);
    else if (option == "--cases")
      hunt.cases = static_cast<std::uint64_t>(value);
    else if (option == "--minutes")
      hunt.minutes = value;
    else
      throw std::invalid_argument(option + " is no option");
  }
  if ((hunt.cases > 0) == (hunt.minutes > 0.0))
    throw std::invalid_argument("either --cases or --minutes has to be above 0");
  return hunt;
}

/// With what it takes to ask again: the case, and for the command its options and the machine, whose numbers are there
/// as far as doubles have them.
void report(const Hunt& hunt, std::uint64_t number, const Subject& subject, const Contradiction& found)
{
  const auto file =
      std::filesystem::absolute("hunt_" + std::to_string(hunt.seed) + "_" + std::to_string(number) + ".urdf");
  std::ofstream(file) << writeUrdf(subject.machine);
  std::cout << "CONTRADICTION: " << found.what() << "\nagain: scripts/hunt --seed " << hunt.seed << " --first "
            << number << " --cases 1\nmachine: --urdf " << file.string() << "\n"
            << inWords(subject.criterion) << std::endl;
}

/// @return whether nothing contradicts
bool huntOne(const Hunt& hunt, std::uint64_t number, Tally& tally)
{
  Random random(hunt.seed * 1000003 + number);
  const auto subject = drawnSubject(random);
  ++tally[subject ? "machines" : "draws without machine"];
  if (!subject)
    return true;
  try
  {
    Hunter hunter(*subject, random, tally);
    hunter.huntBoxes(30);
    hunter.huntContainments(3);
    hunter.huntLargest();
    hunter.huntPaths(3);
    if (number % 8 == 0)
      hunter.huntTolerances();
  }
  catch (const Contradiction& found)
  {
    report(hunt, number, *subject, found);
    return false;
  }
  return true;
}

int huntAll(const Hunt& hunt)
{
  const auto begin = std::chrono::steady_clock::now();
  const std::chrono::duration<double> limit(60.0 * hunt.minutes);
  Tally tally;
  std::uint64_t number = hunt.first;
  int contradictions = 0;
  for (; hunt.cases > 0 ? number < hunt.first + hunt.cases : std::chrono::steady_clock::now() - begin < limit; ++number)
    contradictions += huntOne(hunt, number, tally) ? 0 : 1;
  std::cout << "seed " << hunt.seed << ", cases " << hunt.first << " to " << number - 1 << ":";
  for (const auto& [what, count] : tally)
    std::cout << " " << count << " " << what << ",";
  std::cout << " " << contradictions << " contradictions" << std::endl;
  return contradictions == 0 ? 0 : 1;
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace

int main(int argc, char** argv)
{
  using namespace pkm_workspace::test;
  try
  {
    return huntAll(huntOf(argc, argv));
  }
  catch (const std::invalid_argument& error)
  {
    std::cerr << error.what() << "\n" << USAGE;
    return 2;
  }
}
