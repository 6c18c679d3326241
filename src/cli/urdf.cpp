// SPDX-License-Identifier: BSD-3-Clause
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "command.h"
#include "output.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"
#include "pkm_workspace/version.h"

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
    return "Writes the URDF of a machine of the catalogue, to standard output or to a file. It can be read by the "
           "other\n"
           "commands and by the node, and shown by rviz.\n\n"
           "  pkm urdf --machine orthoglide --length 0.31058 --output orthoglide.urdf\n"
           "  pkm urdf --machine uranesx --lambda 0.05\n"
           "  pkm urdf --machine uranesx --length 0.25 --rail-radius 0.12 --platform-radius 0.03\n";
  }

  void declare(Options& options) override
  {
    options.choice("machine", machine_, { "orthoglide", "uranesx" }, "which machine");
    options.number("length", length_, LENGTH_POSITIVE, "strut length L");
    options.number("rail-radius", rail_radius_, LENGTH_POSITIVE,
                   "uranesx: radius R of the circle of the rails, R - r below L; without it, (7/13 + lambda) L");
    options.number("platform-radius", platform_radius_, LENGTH_POSITIVE,
                   "uranesx: radius r of the platform, below R; without it, 3/26 L");
    options.number("lambda", lambda_, Quantity(),
                   "uranesx: the paper's lambda, in place of --rail-radius; without it, 0");
    options.text("output", output_, "FILE", "file to write; without it, standard output");
    options.require({ "machine" });
    options.check({ "machine", "rail-radius", "platform-radius", "lambda" }, [this](Problems& problems) {
      if (machine_ == "orthoglide" && (rail_radius_ || platform_radius_ || lambda_))
        problems.push_back("an orthoglide has only a length");
    });
    options.check({ "rail-radius", "lambda" }, [this](Problems& problems) {
      if (rail_radius_ && lambda_)
        problems.push_back("only one of the two can be given");
    });
    options.check({ "machine", "length", "rail-radius", "platform-radius", "lambda" },
                  [this](Problems& problems) { makeMachine(problems); });
  }

  Answer answer() override
  {
    const std::string urdf = writeUrdf(*made_);
    Json json = { { "machine", made_->name() },
                  { "geometry_hash", readUrdf(urdf).machine.geometryHash() },
                  { "version", version() } };
    if (output_.empty())
    {
      json["urdf"] = urdf;
      return { json, urdf };
    }
    writeFile(urdf);
    json["output"] = output_;
    return { json, "Wrote machine '" + made_->name() + "' to " + output_ + "\n" };
  }

private:
  void makeMachine(Problems& problems)
  {
    try
    {
      made_ = machine_ == "orthoglide" ? orthoglide(length_) : uranesx(railRadius(), platformRadius(), length_);
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back(reason.what());
    }
  }

  Interval railRadius() const
  {
    const Interval by_lambda = (Interval(7.0) / Interval(13.0) + Interval(lambda_.value_or(0.0))) * Interval(length_);
    return rail_radius_ ? Interval(*rail_radius_) : by_lambda;
  }

  Interval platformRadius() const
  {
    const Interval by_length = Interval(3.0) / Interval(26.0) * Interval(length_);
    return platform_radius_ ? Interval(*platform_radius_) : by_length;
  }

  /// @throws std::invalid_argument with the reason of the system
  void writeFile(const std::string& content) const
  {
    errno = 0;
    std::ofstream file(output_);
    file << content;
    file.close();
    if (!file)
      throw std::invalid_argument("--output " + output_ + ": cannot be written: " + std::strerror(errno));
  }

  std::string machine_;
  double length_ = 1.0;
  std::optional<double> rail_radius_;
  std::optional<double> platform_radius_;
  std::optional<double> lambda_;
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
