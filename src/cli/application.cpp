// SPDX-License-Identifier: BSD-3-Clause
#include "application.h"

#include <algorithm>
#include <new>
#include <ostream>
#include <stdexcept>
#include <system_error>

#include "command.h"
#include "output.h"
#include "pkm_workspace/version.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
enum ExitCode
{
  ANSWERED = 0,
  FAILED = 1,
  BAD_INPUT = 2
};

const NamedCommand COMMANDS[] = {
  { "evaluate", "how the machine stands at one tool point", makeEvaluate },
  { "largest", "the largest region of a shape in which every point is dextrous", makeLargest },
  { "check", "whether every point of a given box is dextrous", makeCheck },
  { "path", "whether every point of a path of lines and arcs is dextrous", makePath },
  { "place", "where a path or a part is dextrous with the largest margin, and how large it may be", makePlace },
  { "pave", "the dextrous or reachable set as boxes, and its volume", makePave },
  { "connect", "whether a path in the set leads from one point to another", makeConnect },
  { "compare", "machines with each other, or the paper with what is proved", makeCompare },
  { "study", "the best machine of a family with one parameter; with a FILE, a table of many designs", makeStudy },
  { "singularities", "that there are none, or where one is", makeSingularities },
  { "guarantee", "the speed, force, stiffness, error that the tool keeps everywhere in a region", makeGuarantee },
  { "tolerate", "how exactly a machine has to be built for a region", makeTolerate },
  { "conditioning", "the global conditioning index of a region or of the whole set", makeConditioning },
  { "urdf", "the URDF of a machine of the catalogue", makeUrdf },
  { "import", "the URDF of a delta from the configuration of its controller", makeImport },
  { "export", "a proved region as limits for the configuration of a controller", makeExport },
  { "verify", "that each step of a certificate holds", makeVerify },
};

/// Python's alone.
constexpr const char* REPORT = "report";
constexpr const char* REPORT_SUMMARY = "a machine, machines side by side, or a study as a page to read and print";

constexpr const char* LOST_OUTPUT = "standard output cannot be written";

constexpr const char* INTRODUCTION =
    "Proved answers about machines with three legs and a platform that never turns (Orthoglide, UraneSX, "
    "linear and rotary deltas, tripods): where, and how large, is the region in which the machine is certain to behave "
    "like a good machine tool? A point is dextrous when the machine reaches it and its velocity transmission factors "
    "lie within bounds there. No ROS master is needed.";

constexpr const char* CONVENTIONS =
    "Lengths are in metres, times in seconds, points in the frame of the URDF's root link. The answer goes to standard "
    "output, with --json as one JSON object; warnings and progress go to standard error. Exit code: 0 answered (also "
    "when the answer is \"none\"), 2 bad input, 1 the memory, a disk, standard output or the program itself failed. "
    "pkm --version prints the version.";

std::string listed(const Words& examples)
{
  return "\nexamples:\n  " + joined(examples, "\n  ") + "\n\n";
}

void printHelp(std::ostream& out)
{
  std::vector<Words> rows;
  for (const NamedCommand& command : COMMANDS)
    rows.push_back({ command.name, command.summary });
  rows.push_back({ REPORT, REPORT_SUMMARY });
  out << "usage: pkm COMMAND [OPTION...], or rosrun pkm_workspace pkm COMMAND [OPTION...]\n\n"
      << wrapped(INTRODUCTION) << "\ncommands (pkm COMMAND --help tells more):\n"
      << aligned(rows, Align::LEFT)
      << listed({ "pkm urdf --machine orthoglide --output orthoglide.urdf",
                  "pkm largest --urdf orthoglide.urdf --shape cube" })
      << wrapped(CONVENTIONS);
}

void printHelp(const NamedCommand& entry, const Command& command, const Options& options, std::ostream& out)
{
  out << "usage: pkm " << entry.name << options.leadingWord() << " [OPTION...]\n\n"
      << wrapped(command.description()) << listed(command.examples());
  options.describe(out);
}

Json listed(const Box& box)
{
  Json ends = Json::array();
  for (int axis = 0; axis < 3; ++axis)
    for (const double end : { box.lower[axis], box.upper[axis] })
      ends.push_back(end);
  return ends;
}

void print(const LongList& list, std::ostream& out)
{
  writeList(list.goes_on, list.next, 2, out);
}

void print(const BoxLists& lists, std::ostream& out)
{
  const char* separator = "{";
  for (const auto& [name, make] : lists)
  {
    const std::vector<Box> boxes = make();
    out << separator << "\n    " << Json(name).dump() << ": ";
    writeList(
        boxes.size(), [&boxes](std::size_t k) { return listed(boxes[k]); }, 4, out);
    separator = ",";
  }
  out << "\n  }";
}

void print(const std::function<Json()>& make, std::ostream& out)
{
  out << make().dump();
}

void print(const Answer& answer, bool json, std::ostream& out)
{
  if (json)
  {
    std::string object = answer.json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
    if (!answer.long_members.empty())
      object.resize(object.size() - 2);  // "\n}"
    out << object;
    for (const auto& [name, member] : answer.long_members)
    {
      out << ",\n  " << Json(name).dump() << ": ";
      std::visit([&out](const auto& known) { print(known, out); }, member);
    }
    out << (answer.long_members.empty() ? "\n" : "\n}\n");
  }
  else
  {
    out << answer.text();
    if (answer.long_text)
      answer.long_text(out);
  }
  out << std::flush;
}

/// What was computed is kept even if nobody reads the answer.
void printAndSave(Command& command, bool json, std::ostream& out)
{
  const Answer answer = withRemedy(command.remedy(), [&command] { return command.answer(); });
  std::string lost;
  try
  {
    print(answer, json, out);
  }
  catch (const std::ios_base::failure&)
  {
    lost = LOST_OUTPUT;
  }
  try
  {
    command.save();
  }
  catch (const std::invalid_argument& reason)
  {
    throw Failure((lost.empty() ? "the answer is complete, but it was not saved: " : lost + "\n") + reason.what());
  }
  if (!lost.empty())
    throw Failure(lost);
}

void runCommand(const NamedCommand& entry, const Words& words, std::ostream& out, std::ostream& err)
{
  const auto command = entry.make();
  Shell shell(err);
  command->setCaller(shell);
  bool json = false;
  bool help = std::find(words.begin(), words.end(), "--help") != words.end();
  Options options(help);
  command->declare(options);
  options.flag("json", json, "prints one JSON object in place of the text");
  options.flag("help", help, "prints this text");
  if (help)
    return printHelp(entry, *command, options, out);
  options.parse(words);
  for (const std::string& warning : command->warnings())
    shell.warn(warning);
  for (const std::string& note : command->notes())
    shell.note(note);
  printAndSave(*command, json, out);
}

void dispatch(const Words& arguments, std::ostream& out, std::ostream& err)
{
  const std::string first = arguments.empty() ? "" : arguments[0];
  if (first == "--help")
    printHelp(out);
  else if (first == "--version")
    out << "pkm_workspace " << version() << "\n";
  else if (first.empty())
    throw std::invalid_argument("a command is missing");
  else if (first == "study" && arguments.size() > 1 && arguments[1].compare(0, 2, "--") != 0)
    becomePython("study", { arguments.begin() + 1, arguments.end() });
  else if (first == REPORT)
    becomePython("report", { arguments.begin() + 1, arguments.end() });
  else
    runCommand(findCommand(first), { arguments.begin() + 1, arguments.end() }, out, err);
  out << std::flush;
}

void tell(const std::string& reason, std::ostream& err)
{
  for (const std::string& line : linesOf(reason))
    err << "pkm: " << line << "\n";
}
}  // namespace

const NamedCommand& findCommand(const std::string& name)
{
  Words names;
  for (const NamedCommand& command : COMMANDS)
  {
    if (command.name == name)
      return command;
    names.push_back(command.name);
  }
  names.emplace_back(REPORT);
  throw std::invalid_argument("'" + name + "' is not a command; allowed: " + joined(names, ", "));
}

const char* const OUT_OF_MEMORY =
    "pkm: the memory is used up: ask for less (fewer points, a coarser --resolution, --max-memory), or free some\n";

int run(const Words& arguments, std::ostream& out, std::ostream& err)
{
  try
  {
    const std::string distrust = rounding::selfTest();
    if (!distrust.empty())
      throw Failure("the arithmetic of this computer cannot be trusted: " + distrust);
    out.exceptions(std::ios::badbit | std::ios::failbit);
    dispatch(arguments, out, err);
    return ANSWERED;
  }
  catch (const std::invalid_argument& reason)
  {
    tell(reason.what(), err);
    err << "pkm: see pkm --help or pkm COMMAND --help\n";
    return BAD_INPUT;
  }
  catch (const Failure& failure)
  {
    tell(failure.what(), err);
  }
  catch (const std::ios_base::failure&)
  {
    tell(LOST_OUTPUT, err);
  }
  catch (const std::bad_alloc&)
  {
    err << OUT_OF_MEMORY;
  }
  catch (const std::system_error& failure)
  {
    tell(std::string("the system refuses what is needed: ") + failure.what(), err);
  }
  catch (const std::exception& failure)
  {
    tell(std::string("this is a defect of pkm, please report it with the command line: ") + failure.what(), err);
  }
  return FAILED;
}
}  // namespace cli
}  // namespace pkm_workspace
