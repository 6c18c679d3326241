// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/certificate/verify.h"
#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/common/whole_file.h"
#include "progress.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// Of a certificate.
constexpr std::size_t LARGEST_CERTIFICATE = std::size_t(1) << 28;

class Verify : public Command
{
public:
  std::string description() const override
  {
    return "Checks a certificate that pkm largest, check, path or pave wrote: every step of the proof, in arithmetic "
           "of its own that shares nothing with the search. Says what holds, or the first thing that does not; then "
           "the exit status is 1. scripts/check_certificate.py does the same with nothing but Python.";
  }

  Words examples() const override { return { "pkm verify cube.json" }; }

  void declare(Options& options) override
  {
    options.text("file", path_, "FILE", "a certificate");
    options.lead("file");
    options.require({ "file" });
    options.flag("progress", progress_, PROGRESS_HELP);
  }

  Answer answer() override
  {
    Progress progress = caller().progress(progress_);
    const auto stop = caller().stop();
    result_ = verifyCertificate(readWholeFile(path_, LARGEST_CERTIFICATE), [&](std::int64_t leaves) {
      progress.tell(std::to_string(leaves) + " boxes verified");
      return !*stop;
    });
    std::string text;
    for (const std::string& claim : result_.verified)
      text += wrapped("Verified: " + claim + ".");
    return { { { "verified", result_.verified }, { "refused", result_.refused } }, text };
  }

  void save() override
  {
    if (!result_.refused.empty())
      throw Failure("refused: " + result_.refused);
  }

private:
  std::string path_;
  bool progress_ = false;
  Verification result_;
};
}  // namespace

std::unique_ptr<Command> makeVerify()
{
  return std::make_unique<Verify>();
}
}  // namespace cli
}  // namespace pkm_workspace
