// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/import/firmware.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Json importJson(const SourcePlace& place)
{
  return { { "file", place.file }, { "line", place.line } };
}

Json importJson(const TakenValue& taken)
{
  Json json = importJson(taken.place);
  json["key"] = taken.key;
  json["value"] = taken.written;
  json["meaning"] = taken.meaning;
  return json;
}

Json importJson(const LeftAside& left)
{
  Json json = importJson(left.place);
  json["key"] = left.key;
  json["reason"] = left.reason;
  return json;
}

template <class Item>
Json importJson(const std::vector<Item>& items)
{
  Json json = Json::array();
  for (const Item& item : items)
    json.push_back(importJson(item));
  return json;
}

class Import : public Command
{
public:
  std::string description() const override
  {
    return "Writes the URDF of a delta that the configuration of its controller describes: a linear one (Klipper, "
           "Marlin, "
           "RepRapFirmware, LinuxCNC) or a rotary one (LinuxCNC, grblHAL), to standard output or to a file. Joint "
           "values "
           "of the URDF are the controller's own, in metres or radians. What was taken of the file, and what was left "
           "aside and why, is listed on standard error; "
           "with --output or --json it is part of the answer. What each format means: docs/firmware.md.";
  }

  Words examples() const override
  {
    return { "pkm import printer.cfg --output machine.urdf",
             "pkm import printer.cfg --format klipper --name workshop_delta" };
  }

  void declare(Options& options) override
  {
    options.text("file", path_, "FILE", "configuration of the controller; as the first word it needs no --file");
    options.lead("file");
    options.choice("format", format_, firmwareFormats(), "what the file is; without it, recognised from the text");
    options.text("name", name_, "NAME", "name of the machine; without it, the format's name and _delta");
    declareOutput(options, "output", output_, "file to write; without it, standard output");
    declareTolerances(
        options, [this]() -> ToleranceWish& { return tolerances_; }, "; written into the URDF");
    options.require({ "file" });
  }

  Words warnings() const override { return read().warnings; }
  Words notes() const override { return output_.empty() ? linesAbout(imported()) : Words(); }

  Answer answer() override
  {
    const Machine& machine = read().machine;
    Json json = contextOf(machine);
    json["format"] = imported().format;
    json["taken"] = importJson(imported().taken);
    json["left_aside"] = importJson(imported().left_aside);
    if (output_.empty())
    {
      json["urdf"] = urdf_;
      return { json, urdf_ };
    }
    writeOutput(output_, urdf_);
    json["output"] = output_;
    return { json, joined(linesAbout(imported()), "\n") + "\n" + wroteMachine(machine, output_) };
  }

  const UrdfMachine* made() override { return &read(); }

private:
  const UrdfMachine& read() const
  {
    if (!read_)
    {
      urdf_ = writeUrdf(imported().machine);
      read_ = readUrdf(urdf_);
    }
    return *read_;
  }

  /// Read once, when the options are known. @throws std::invalid_argument with all that is wrong in the file
  const FirmwareMachine& imported() const
  {
    if (!imported_)
    {
      imported_ = importFirmwareFile(path_, format_);
      if (!name_.empty())
        imported_->machine.name = name_;
      imported_->machine.tolerances = tolerances_.both().over({});
    }
    return *imported_;
  }

  static Words linesAbout(const FirmwareMachine& machine)
  {
    Words lines;
    for (const TakenValue& taken : machine.taken)
      lines.push_back(toText(taken.place) + ": took " + taken.key + " = " + taken.written + ": " + taken.meaning);
    for (const LeftAside& left : machine.left_aside)
      lines.push_back(toText(left.place) + ": left aside " + left.key + ": " + left.reason);
    return lines;
  }

  std::string path_;
  std::string format_;
  ToleranceWish tolerances_;
  std::string name_;
  std::string output_;
  mutable std::optional<FirmwareMachine> imported_;
  mutable std::string urdf_;  ///< of it
  mutable std::optional<UrdfMachine> read_;
};
}  // namespace

std::unique_ptr<Command> makeImport()
{
  return std::make_unique<Import>();
}
}  // namespace cli
}  // namespace pkm_workspace
