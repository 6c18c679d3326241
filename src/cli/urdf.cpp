// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// What may be given of a machine; what is not given follows from the rest.
struct Dimensions
{
  double length = 1.0;                    ///< L [m]
  std::optional<double> rail_radius;      ///< R [m]
  std::optional<double> platform_radius;  ///< r [m]
  std::optional<double> lambda;           ///< R / L = 7/13 + lambda
};

Machine makeUranesx(const Dimensions& given)
{
  const Interval length(given.length);
  const Interval by_lambda = (Interval(7.0) / Interval(13.0) + Interval(given.lambda.value_or(0.0))) * length;
  const Interval by_length = Interval(3.0) / Interval(26.0) * length;
  return uranesx(given.rail_radius ? Interval(*given.rail_radius) : by_lambda,
                 given.platform_radius ? Interval(*given.platform_radius) : by_length, given.length);
}

struct NamedMachine
{
  const char* name;
  Words dimensions;  ///< the options that it knows
  Machine (*make)(const Dimensions& given);
};

const NamedMachine MACHINES[] = {
  { "orthoglide", { "length" }, [](const Dimensions& given) { return orthoglide(given.length); } },
  { "orthoglide_prototype", {}, [](const Dimensions&) { return orthoglidePrototype(); } },
  { "uranesx", { "length", "rail-radius", "platform-radius", "lambda" }, makeUranesx },
};

Words machineNames()
{
  Words names;
  for (const NamedMachine& machine : MACHINES)
    names.push_back(machine.name);
  return names;
}

const NamedMachine& find(const std::string& name)
{
  return *std::find_if(std::begin(MACHINES), std::end(MACHINES), [&](const NamedMachine& m) { return m.name == name; });
}

class Urdf : public Command
{
public:
  std::string description() const override
  {
    return "Writes the URDF of a machine of the catalogue, to standard output or to a file. It can be read by "
           "the other commands and by the node, and shown by rviz.";
  }

  Words examples() const override
  {
    return { "pkm urdf --machine orthoglide --length 0.31058 --output orthoglide.urdf",
             "pkm urdf --machine uranesx --lambda 0.05",
             "pkm urdf --machine uranesx --length 0.25 --rail-radius 0.12 --platform-radius 0.03" };
  }

  void declare(Options& options) override
  {
    options.choice("machine", machine_, machineNames(), "which machine");
    options.number("length", given_.length, LENGTH_POSITIVE, "strut length L");
    options.number("rail-radius", given_.rail_radius, LENGTH_POSITIVE,
                   "uranesx: radius R of the circle of the rails, R - r below L; without it, (7/13 + lambda) L");
    options.number("platform-radius", given_.platform_radius, LENGTH_POSITIVE,
                   "uranesx: radius r of the platform, below R; without it, 3/26 L");
    options.number("lambda", given_.lambda, Quantity(),
                   "uranesx: the paper's lambda, in place of --rail-radius; without it, 0");
    declareOutput(options, "output", output_, "file to write; without it, standard output");
    options.require({ "machine" });
    options.check({ "rail-radius", "lambda" }, [this](Problems& problems) {
      if (given_.rail_radius && given_.lambda)
        problems.push_back("only one of the two can be given");
    });
    for (const std::string& dimension : find("uranesx").dimensions)
      options.check({ "machine", dimension }, [this, &options, dimension](Problems& problems) {
        const Words& known = find(machine_).dimensions;
        if (options.given(dimension) && std::find(known.begin(), known.end(), dimension) == known.end())
          problems.push_back("this machine has no such dimension");
      });
    options.check({ "machine", "length", "rail-radius", "platform-radius", "lambda" },
                  [this](Problems& problems) { makeMachine(problems); });
  }

  Answer answer() override
  {
    const std::string urdf = writeUrdf(*made_);
    Json json = contextOf(readUrdf(urdf).machine);
    if (output_.empty())
    {
      json["urdf"] = urdf;
      return { json, urdf };
    }
    try
    {
      writeWholeFile(output_, urdf);
    }
    catch (const std::invalid_argument& reason)
    {
      throw Failure(std::string("--output ") + reason.what());
    }
    json["output"] = output_;
    return { json, "Wrote machine '" + made_->name() + "' to " + output_ + "\n" };
  }

private:
  void makeMachine(Problems& problems)
  {
    try
    {
      made_ = find(machine_).make(given_);
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back(reason.what());
    }
  }

  std::string machine_;
  Dimensions given_;
  std::string output_;
  std::optional<Machine> made_;
};
}  // namespace

std::unique_ptr<Command> makeUrdf()
{
  return std::make_unique<Urdf>();
}
}  // namespace cli
}  // namespace pkm_workspace
