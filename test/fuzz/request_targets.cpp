// SPDX-License-Identifier: BSD-3-Clause
// What the node makes of requests, whatever their fields hold; needs no master.
#include <pkm_workspace/CheckGcode.h>
#include <pkm_workspace/CheckPath.h>
#include <ros/serialization.h>

#include <cstring>
#include <type_traits>

#include "fuzz/targets.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/gcode_message.h"
#include "pkm_workspace/ros/path_message.h"
#include "pkm_workspace/ros/paving_message.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
const char* const WORDS[] = { "",         "cube",     "square", "box",       "sphere", "disc",
                              "cylinder", "polytope", "world",  "base_link", "a",      "no such word" };

/// Fills the fields of any message out of bytes, in their order. After the end all of them are zero and empty.
class FieldFiller
{
public:
  explicit FieldFiller(const std::string& bytes) : bytes_(bytes) {}

  template <class Message>
  std::enable_if_t<std::is_class_v<Message>> next(Message& message)
  {
    ros::serialization::Serializer<Message>::template allInOne<FieldFiller, Message&>(*this, message);
  }
  template <class Number>
  std::enable_if_t<std::is_integral_v<Number>> next(Number& number)
  {
    number = static_cast<Number>(byte());
  }
  /// Mostly a small one, with simple digits; or any at all.
  void next(double& number)
  {
    const auto small = static_cast<signed char>(byte());
    number = small / 16.0;
    if (small >= -64 && small < 64)
      return;
    char raw[sizeof(double)];
    for (char& part : raw)
      part = static_cast<char>(byte());
    std::memcpy(&number, raw, sizeof(number));
  }
  void next(ros::Time& time) { next(time.sec); }
  void next(ros::Duration& duration) { next(duration.sec); }
  void next(std::string& text)
  {
    const unsigned char choice = byte();
    if (choice < std::size(WORDS))
    {
      text = WORDS[choice];
      return;
    }
    text.clear();
    for (int length = choice; length > 0 && at_ < bytes_.size(); --length)
      text += static_cast<char>(byte());
  }
  template <class Element>
  void next(std::vector<Element>& elements)
  {
    elements.resize(byte() % 10);
    for (Element& element : elements)
      next(element);
  }
  template <class Element, std::size_t N>
  void next(boost::array<Element, N>& elements)
  {
    for (Element& element : elements)
      next(element);
  }

private:
  unsigned char byte() { return at_ < bytes_.size() ? static_cast<unsigned char>(bytes_[at_++]) : 0; }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

template <class Message>
Message messageOf(const std::string& bytes)
{
  Message message;
  FieldFiller(bytes).next(message);
  return message;
}

/// Whether nothing is wrong; what is wrong is said.
bool isFine(const Problems& problems)
{
  for (const std::string& problem : problems)
    demand(!problem.empty(), "a problem is a sentence");
  return problems.empty();
}

FramedMachine framed()
{
  static const auto MACHINE = std::make_shared<const Machine>(orthoglidePrototype());
  return { "base_link", MACHINE, MACHINE->geometryHash(), Pose() };
}

void fuzzRegion(const std::string& bytes)
{
  const FramedMachine in = framed();
  const auto request = messageOf<RegionRequest>(bytes);
  isAccepted([&] {
    const Parameters own;
    const RegionQuery query = fromMessage(request, *in.machine, own.query, own, 60.0);
    Problems problems;
    query.validate(problems);
    demand(isFine(problems), "what is accepted is valid");
    demand(!describe(query).empty(), "a query has words");
  });
}

void fuzzPavingRequest(const std::string& bytes)
{
  const auto request = messageOf<PavingRequest>(bytes);
  isAccepted([&] {
    const PavingQuestion question = fromMessage(request, framed(), defaultCriterion(), Parameters(), 60.0);
    Problems problems;
    question.query.validate(problems);
    demand(isFine(problems), "what is accepted is valid");
  });
}

/// What is accepted is sent as hypotheses that read back the same.
void fuzzCriterion(const std::string& bytes)
{
  const FramedMachine in = framed();
  const auto request = messageOf<CriterionRequest>(bytes);
  isAccepted([&] {
    Problems problems;
    const Criterion criterion = fromMessage(request, *in.machine, defaultCriterion(), problems);
    if (!isFine(problems))
      return;
    criterion.validate(problems);
    demand(isFine(problems), "what is accepted is valid");
    const Premises premises = in.premises(criterion);
    demand(fromMessage(toMessage(premises, 0.0)) == premises, "hypotheses read back the same");
    machineOf(request, *in.machine);
  });
}

void fuzzPathRequest(const std::string& bytes)
{
  const auto request = messageOf<CheckPath::Request>(bytes);
  isAccepted([&] {
    forEachSegment(request, [](const PathSegment& segment) {
      demand(segment.point(0.0).allFinite() && segment.point(1.0).allFinite(), "segments have points");
    });
  });
  isAccepted([&] { ratesOf(request, {}); });
  isAccepted([&] { frameOf(request); });
}

void fuzzGcodeRequest(const std::string& bytes)
{
  const auto request = messageOf<CheckGcode::Request>(bytes);
  isAccepted([&] {
    JobTask job;
    Problems problems;
    read(request, job, problems);
    isFine(problems);
  });
  isAccepted([&] { ratesOf(request, {}); });
}
}  // namespace

const std::vector<FuzzTarget> FUZZ_TARGETS = {
  { "region_request", fuzzRegion },    { "paving_request", fuzzPavingRequest }, { "criterion_request", fuzzCriterion },
  { "path_request", fuzzPathRequest }, { "gcode_request", fuzzGcodeRequest },
};
}  // namespace test
}  // namespace pkm_workspace
