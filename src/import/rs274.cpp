// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/import/rs274.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <stdexcept>

#include "canonical_moves.h"
#include "pkm_workspace/common/child_process.h"

// LinuxCNC (LinuxCNC/linuxcnc): src/emc/sai/driver.cc: -g starts without questions, -n 2 ends at the first error, -t
// names the table of tools, -v the file of parameters, in inches whatever the machine's are. So all that has a length
// is set by lines in front of the job. On standard error it prints the reason, then the line that it is about.

namespace pkm_workspace
{
namespace
{
constexpr const char* PROGRAM = "rs274";
constexpr const char* END_OF_JOB = " PROGRAM_END()";
constexpr const char* EXECUTING = "executing";  // which it prints first
constexpr std::size_t LONGEST_REASON = 1 << 16;
const std::string BLANKS = " \t\r";

/// Of the first word N of a line, and of the blanks around it.
std::size_t endOfNumber(const std::string& line, std::size_t begin)
{
  if (begin == line.size() || (line[begin] != 'N' && line[begin] != 'n'))
    return begin;
  const std::size_t digits = line.find_first_not_of(BLANKS, begin + 1);
  const std::size_t end = std::min(line.find_first_not_of("0123456789", digits), line.size());
  return digits == std::string::npos || end == digits ? begin : end;
}

/// The job with the number of each line as its word N, which rs274 prints with each call.
class NumberedJob
{
public:
  NumberedJob(const Rs274Job& job, const std::string& path) : job_(job), file_(path)
  {
    job.lines([this](const std::string& line, std::size_t number) { write(line, number); });
    if (!has_setup_)
      writeSetup();
    file_.close();
    if (!file_)
      throw std::invalid_argument(path + ": a copy of " + job.name + " for rs274 cannot be written: free some space");
  }

  std::size_t lines() const { return lines_; }

private:
  void write(const std::string& line, std::size_t number)
  {
    lines_ = number;
    const std::size_t begin = std::min(line.find_first_not_of(BLANKS), line.size());
    const bool is_mark = begin < line.size() && line[begin] == '%';
    if (!has_setup_ && begin < line.size() && !is_mark)
      writeSetup();
    if (begin < line.size() && line[begin] == '/')
      throw std::invalid_argument(job_.name + ":" + std::to_string(number) +
                                  ": whether a line behind / counts depends on a switch; remove the line, or the /");
    if (begin == line.size() || is_mark)
      file_ << line << '\n';
    else
      file_ << 'N' << number << ' ' << line.substr(endOfNumber(line, begin)) << '\n';
    if (is_mark && !has_setup_)
      writeSetup();
  }

  /// Where the tool is, or that this is not known, nor where G28 and G30 go; offsets and tools; no motion in effect.
  void writeSetup()
  {
    has_setup_ = true;
    const GcodeSetup& setup = job_.setup;
    say("G21 G53 G0" + axes({ gcode::UNKNOWN, gcode::UNKNOWN, gcode::UNKNOWN }));
    say("G28.1");
    say("G30.1");
    for (std::size_t k = 0; k < GcodeSetup::SYSTEMS; ++k)
      say("G10 L2 P" + std::to_string(k + 1) + axes(gcode::fromMetres(setup.work_offsets[k])));
    for (const auto& [number, length] : setup.tool_lengths)
      say("G10 L1 P" + std::to_string(number) + " Z" + decimal(gcode::fromMetres(length)));
    for (const auto& [number, diameter] : setup.tool_diameters)
      say("G10 L1 P" + std::to_string(number) + " R" + decimal(gcode::fromMetres(0.5 * diameter)));
    if (setup.start)
      say("G53 G0" + axes(gcode::difference(gcode::fromMetres(*setup.start), gcode::fromMetres(setup.origin))));
    say("G80");
  }

  void say(const std::string& words) { file_ << 'N' << gcode::SETUP_LINE << ' ' << words << '\n'; }

  /// Exactly, in millimetres.
  static std::string decimal(std::int64_t femtometres)
  {
    constexpr std::int64_t OF_MILLIMETRE = 1000000000000;
    const std::string rest = std::to_string(std::abs(femtometres % OF_MILLIMETRE) + OF_MILLIMETRE).substr(1);
    return (femtometres < 0 ? "-" : "") + std::to_string(std::abs(femtometres / OF_MILLIMETRE)) + "." + rest;
  }

  static std::string axes(const gcode::Place& place)
  {
    return " X" + decimal(place[0]) + " Y" + decimal(place[1]) + " Z" + decimal(place[2]);
  }

  const Rs274Job& job_;
  std::ofstream file_;
  bool has_setup_ = false;
  std::size_t lines_ = 0;
};

void writeTools(const GcodeSetup& setup, const std::string& path)
{
  std::set<int> numbers;
  for (const auto& [number, length] : setup.tool_lengths)
    numbers.insert(number);
  for (const auto& [number, diameter] : setup.tool_diameters)
    numbers.insert(number);
  std::ofstream file(path);
  int pocket = 0;
  for (const int number : numbers)
    file << 'T' << number << " P" << ++pocket << '\n';
}

/// Without what is about the copy of the job.
std::string ofJob(std::string reason)
{
  reason.erase(std::min(reason.find(" from line:"), reason.size()));
  const std::size_t begin = reason.find(" in file:");
  if (begin != std::string::npos)
    reason.erase(begin, std::min(reason.find(' ', begin + 1 + std::string("in file:").size()), reason.size()) - begin);
  return reason;
}

/// What the program says is wrong: its last two lines are the reason and the line that it is about.
std::string reasonIn(const std::string& errors, const std::string& job)
{
  std::vector<std::string> lines;
  std::string rest = errors.substr(0, LONGEST_REASON);
  for (std::size_t end = 0; (end = rest.find('\n')) != std::string::npos; rest.erase(0, end + 1))
    if (end > 0 && rest.substr(0, end) != EXECUTING)
      lines.push_back(rest.substr(0, end));
  if (lines.empty())
    return job + ": rs274 ends without the end of the job, and gives no reason";
  if (lines.size() < 2)
    return job + ": " + lines.back();
  const std::string& line = lines.back();
  const std::string reason = ofJob(lines[lines.size() - 2]);
  const std::size_t end = endOfNumber(line, 0);
  const std::string place = end > 1 ? ":" + line.substr(1, end - 1) : "";
  const bool wants_tool = reason.find("tool table") != std::string::npos;
  return job + place + ": " + reason + (wants_tool ? "; give the length of this tool" : "");
}

std::string missing(const std::string& reason)
{
  return reason +
         "; install LinuxCNC (Debian: linuxcnc-uspace) and have the folder of rs274 in PATH, or leave the "
         "interpreter out: then the words that docs/gcode.md lists are read without it";
}
}  // namespace

std::size_t interpretByRs274(const Rs274Job& job, const LineTaker& take)
{
  const TemporaryFolder folder;
  const NumberedJob numbered(job, folder.path("job.ngc"));
  writeTools(job.setup, folder.path("tools.tbl"));
  const std::string errors = folder.path("errors");
  std::unique_ptr<ChildProcess> program;
  try
  {
    program = std::make_unique<ChildProcess>(
        std::vector<std::string>{ PROGRAM, "-g", "-n", "2", "-t", folder.path("tools.tbl"), "-v",
                                  folder.path("parameters.var"), folder.path("job.ngc") },
        errors);
  }
  catch (const std::invalid_argument& reason)
  {
    throw std::invalid_argument(missing(reason.what()));
  }
  bool has_ended = false;
  readLines(
      PROGRAM, [&](char* data, std::size_t size) { return program->read(data, size, job.is_over); },
      [&](const std::string& line, std::size_t number) {
        take(line, number);
        has_ended = has_ended || line.find(END_OF_JOB) != std::string::npos;
      });
  const int code = program->wait(job.is_over);
  if (job.is_over())
    throw std::invalid_argument(job.name + ": rs274 was not at the end when " + job.ended_by() +
                                " ended it, and nothing is said of a part of a job");
  if (code != 0)
    throw std::invalid_argument(reasonIn(readWholeFile(errors, LARGEST_LINES), job.name));
  if (!has_ended)
    throw std::invalid_argument(job.name + ": rs274 did not come to the end of the job; end it with M2");
  return numbered.lines();
}
}  // namespace pkm_workspace
