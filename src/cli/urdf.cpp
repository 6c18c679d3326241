// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <stdexcept>

#include "command.h"
#include "common_options.h"
#include "draft_options.h"
#include "named_machines.h"
#include "output.h"
#include "pkm_workspace/import/machine_file.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
class Urdf : public Command
{
public:
  std::string description() const override
  {
    return "Writes the URDF of a machine: from the numbers that you measured on it (--linear-delta, --kind, or a "
           "machine "
           "file: --template writes one to fill in, --from reads it), or from the catalogue (--orthoglide, --uranesx, "
           "which is a linear delta, --machine). Legs are struts of fixed length on sliders, struts of variable "
           "length, "
           "or cranks with forearms, mixed freely. The zero configuration is solved. The URDF can be read by the other "
           "commands "
           "and by the node, and is shown by rviz. Angles are degrees here, lengths metres.";
  }

  Words examples() const override
  {
    return {
      "pkm urdf --linear-delta --rail-radius 0.13 --platform-radius 0.03 --length 0.269 --travel 0 0.35",
      "pkm urdf --kind crank --base-radius 0.164 --crank 0.524 --length 1.244 --platform-radius 0.044 --travel -35 85",
      "pkm urdf --template --output machine.yaml",
      "pkm urdf --from machine.yaml --output machine.urdf",
      "pkm urdf --orthoglide --length 0.31058 --output orthoglide.urdf",
      "pkm urdf --uranesx --lambda 0.05"
    };
  }

  void declare(Options& options) override
  {
    declareSources(options);
    declareOutput(options, "output", output_, "file to write; without it, standard output");
    options.number("lambda", given_.lambda, Quantity(),
                   "uranesx: the paper's lambda, R = (7/13 + lambda) L, in place of --rail-radius; without it, 0");
    options.text("name", draft_.name, "NAME", "name of a machine by its numbers; without it, machine");
    for (const DraftKey& key : legKeys())
      declareLegs(options, key);
    for (const DraftKey& key : machineKeys())
      declareMachine(options, key);
    options.check({ "rail-radius", "lambda" }, [this, &options](Problems& problems) {
      if (options.given("rail-radius") && given_.lambda)
        problems.push_back("only one of the two can be given");
    });
    declareTolerances(
        options, [this]() -> ToleranceWish& { return tolerances_; }, "; written into the URDF");
    Words names = allNames(), tolerances = toleranceOptions();
    names.insert(names.end(), tolerances.begin(), tolerances.end());
    options.check(names, [this, &options](Problems& problems) { make(options, problems); });
  }

  Words warnings() const override { return is_template_ ? Words() : remarksOn(read()); }

  Answer answer() override
  {
    const std::string text = is_template_ ? machineFileTemplate(kind_) : urdf_;
    Json json = is_template_ ? Json() : contextOf(read().machine);
    if (output_.empty())
    {
      json[is_template_ ? "machine_file" : "urdf"] = text;
      return { json, text };
    }
    writeOutput(output_, text);
    json["output"] = output_;
    const std::string fill_in = "Wrote a machine file to " + output_ + "\nFill it in, then: pkm urdf --from " +
                                output_ + " --output machine.urdf\n";
    return { json, is_template_ ? fill_in : wroteMachine(read().machine, output_) };
  }

  const UrdfMachine* made() override { return is_template_ ? nullptr : &read(); }

private:
  /// The machine, read once.
  const UrdfMachine& read() const
  {
    if (!read_)
      read_ = readUrdf(urdf_);
    return *read_;
  }

  void declareSources(Options& options)
  {
    options.flag("linear-delta", is_delta_,
                 "a machine by its numbers, from --rail-radius, --length and --travel on; these alone mean it, too");
    options.text("from", file_, "FILE", "a machine file (YAML)");
    options.flag("template", is_template_, "writes a machine file to fill in, with comments; for legs of a --kind");
    options.flag("orthoglide", is_orthoglide_, "the Orthoglide of the paper, --length");
    options.flag("uranesx", is_uranesx_,
                 "the UraneSX of the paper, a linear delta: --length, --rail-radius (without it, (7/13 + lambda) L), "
                 "--platform-radius (without it, 3/26 L), --lambda");
    options.choice("machine", machine_, machineNames(), "a machine of the catalogue by its name");
  }

  void declareLegs(Options& options, const DraftKey& key)
  {
    const std::string name = optionName(key);
    const Quantity quantity = quantityOfKey(key);
    const bool is_name = key.kind == DraftKey::Kind::NAME;
    const bool is_number = !is_name && key.kind != DraftKey::Kind::WORD;
    const std::string help = key.help + (is_number ? "; " + quantity.describe() : std::string());
    options.legs(name, key.values, help, [this, &key, name, quantity, is_name, is_number](const Words& words) {
      if (is_number)
        readNumbers(words, quantity);
      for (std::size_t leg = 0; leg < 3; ++leg)
      {
        const std::size_t first = words.size() == key.size ? 0 : leg * key.size;
        const auto begin = words.begin() + static_cast<std::ptrdiff_t>(first);
        if (!is_name || words.size() == 3)
          draft_.setLeg(leg, key, { begin, begin + static_cast<std::ptrdiff_t>(key.size) }, "--" + name, true);
      }
      if (key.kind == DraftKey::Kind::WORD)
        setKind(words);
      if (is_number)
        isDrive(key) ? setDrives(key, words) : setDimension(key, words);
    });
  }

  void setKind(const Words& words)
  {
    for (const std::string& word : words)
      readChoice(word, { LEG_KINDS.begin(), LEG_KINDS.end() });
    kind_ =
        static_cast<LegDescription::Kind>(std::find(LEG_KINDS.begin(), LEG_KINDS.end(), words[0]) - LEG_KINDS.begin());
    differ_ = differ_ || words.size() == 3;
  }

  void setDrives(const DraftKey& key, const Words& words)
  {
    const std::vector<double> numbers = readNumbers(words, quantityOfKey(key));
    auto& drives = key.kind == DraftKey::Kind::SPEED ? given_.speeds : given_.efforts;
    for (std::size_t leg = 0; leg < 3; ++leg)
      drives[leg] = numbers[numbers.size() == 1 ? 0 : leg];
  }

  /// The same number of a machine of the catalogue.
  void setDimension(const DraftKey& key, const Words& words)
  {
    pkm_workspace::cli::setDimension(key.name, readNumbers(words, quantityOfKey(key)), given_);
    differ_ = differ_ || words.size() == 3 * key.size;
  }

  void declareMachine(Options& options, const DraftKey& key)
  {
    const std::string name = optionName(key);
    const Quantity quantity = quantityOfKey(key);
    options.words(name, key.values,
                  key.help + (key.kind == DraftKey::Kind::WORD ? std::string() : "; each " + quantity.describe()),
                  [this, &key, name, quantity](const Words& words) {
                    if (key.kind != DraftKey::Kind::WORD)
                      readNumbers(words, quantity);
                    draft_.setMachine(key, words, "--" + name);
                  });
  }

  static Words allNames()
  {
    Words names = { "linear-delta", "from", "template", "orthoglide", "uranesx", "machine", "lambda", "name" };
    for (const auto* const keys : { &legKeys(), &machineKeys() })
      for (const DraftKey& key : *keys)
        names.push_back(optionName(key));
    return names;
  }

  /// Chooses the one source that was asked for.
  void make(const Options& options, Problems& problems)
  {
    if (is_orthoglide_ || is_uranesx_)
      machine_ = is_orthoglide_ ? "orthoglide" : "uranesx";
    const int named = is_orthoglide_ + is_uranesx_ + options.given("machine");
    const int sources = is_delta_ + options.given("from") + is_template_ + named;
    if (sources > 1)
      problems.push_back(
          "only one of --linear-delta, --from, --template, --orthoglide, --uranesx and --machine can be "
          "given");
    else if (is_delta_ && options.given("kind"))
      problems.push_back("a linear delta has rails: leave --linear-delta or --kind out");
    else if (sources == 0 && draft_.isEmpty())
      problems.push_back(
          "which machine? Give its numbers (--linear-delta --rail-radius R --length L --travel LO HI), a "
          "machine file (--from FILE; --template writes one), or --machine " +
          joined(machineNames(), "|"));
    else if (named == 1)
      makeNamed(options, problems);
    else if (options.given("from") || is_template_)
      makeFromFile(options, problems);
    else
      tryTo([this] { write(draft_.finished()); }, problems);
  }

  void makeNamed(const Options& options, Problems& problems)
  {
    Words known = namedMachine(machine_).dimensions;
    for (const DraftKey& key : legKeys())
      if (isDrive(key))
        known.push_back(optionName(key));
    for (const std::string& name : allNames())
      if (options.given(name) && name != "machine" && name != machine_ &&
          std::find(known.begin(), known.end(), name) == known.end())
        problems.push_back("this machine has no such dimension: --" + name);
    if (differ_)
      problems.push_back("the legs of this machine are alike; give --kind for legs that differ");
    if (problems.empty())
      tryTo(
          [this] {
            urdf_ = writeUrdf(withGivenTolerances(makeDriven(namedMachine(machine_), given_), tolerances_.both()));
          },
          problems);
  }

  void makeFromFile(const Options& options, Problems& problems)
  {
    const Words names = allNames();
    const auto isNone = [&](const std::string& name) {
      return name == "from" || name == "template" || (name == "kind" && is_template_ && !differ_) ||
             !options.given(name);
    };
    if (!std::all_of(names.begin(), names.end(), isNone))
      problems.push_back(std::string("numbers and a machine file cannot be given together: write them into the file"));
    else if (!is_template_)
      tryTo([this] { write(readMachineFile(file_)); }, problems);
    else if (!tolerances_.both().isEmpty())
      problems.push_back("a machine file to fill in has no tolerances: give them with --from");
  }

  /// With the tolerances that were given; those that no machine of these numbers has are refused.
  void write(MachineDescription machine)
  {
    machine.tolerances = tolerances_.both().over(machine.tolerances);
    urdf_ = writeUrdf(machine);
    read();
  }

  static void tryTo(const std::function<void()>& act, Problems& problems)
  {
    try
    {
      act();
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back(reason.what());
    }
  }

  bool is_delta_ = false;
  bool is_template_ = false;
  bool is_orthoglide_ = false;
  bool is_uranesx_ = false;
  bool differ_ = false;
  LegDescription::Kind kind_ = LegDescription::Kind::RAIL;  ///< of the legs of a machine file
  std::string machine_, file_;
  Dimensions given_;
  MachineDraft draft_;
  ToleranceWish tolerances_;
  std::string output_, urdf_;
  mutable std::optional<UrdfMachine> read_;
};
}  // namespace

std::unique_ptr<Command> makeUrdf()
{
  return std::make_unique<Urdf>();
}
}  // namespace cli
}  // namespace pkm_workspace
