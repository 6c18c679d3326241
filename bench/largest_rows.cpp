// SPDX-License-Identifier: BSD-3-Clause
#include "list_search.h"
#include "pkm_workspace/region/paper_search.h"
#include "problem.h"
#include "rows.h"

namespace pkm_workspace
{
namespace bench
{
namespace
{
constexpr int FINEST_DIGITS = 7;

/// What any way has to say at the end.
struct Answer
{
  bool is_proved = false;
  double size = 0.0;
  double size_upper_bound = 0.0;
  std::int64_t centers = 0;
  std::int64_t points = 0;
};

Answer byOurWay(const Problem& problem, double accuracy)
{
  const LargestRegion region = findByOurWay(problem.machine, problem.is_square, accuracy);
  return { region.status == LargestRegion::Status::PROVEN, region.size, region.size_upper_bound, region.boxes,
           region.verification_boxes };
}

/// In steps of one digit of accuracy, each from the last, as the paper does.
Answer byPaper(const Problem& problem, const BoxClassifier& classify, double accuracy)
{
  PaperQuery query;
  query.shape = problem.is_square ? PaperQuery::Shape::SQUARE : PaperQuery::Shape::CUBE;
  query.centers = problem.centers;
  query.start = problem.machine.zero();
  query.max_boxes = 100000000;
  Answer answer;
  for (double step = 0.1; step > 0.5 * accuracy; step /= 10)
  {
    query.accuracy = step;
    const PaperResult result = findLargestByPaper(classify, query);
    answer.is_proved = result.ending == PaperResult::Ending::EXHAUSTED;
    answer.size = query.start_size = result.size;
    answer.size_upper_bound = result.size_upper_bound;
    answer.centers += result.boxes;
    answer.points += result.looks;
    query.start = result.center;
  }
  return answer;
}

Answer byList(const Problem& problem, ListWay way, double accuracy)
{
  const Eigen::Vector3d edges(1.0, 1.0, problem.is_square ? 0.0 : 1.0);
  const ListAnswer answer = findLargestByList(way, problem.machine, edges, problem.centers, accuracy);
  return { true, answer.size, answer.size_upper_bound, answer.boxes, answer.looks };
}

void addWay(const Problem& problem, int digits, const std::string& way, int repetitions,
            const std::function<Answer(double)>& find)
{
  const std::string accuracy = "1e-" + std::to_string(digits);
  addRow(problem.name, accuracy, way, repetitions, [find, accuracy](benchmark::State& state) {
    Answer answer;
    for (auto _ : state)
      answer = find(std::stod(accuracy));
    if (!answer.is_proved)
      state.SkipWithError("not proved");
    state.counters["size"] = answer.size;
    state.counters["upper"] = answer.size_upper_bound;
    state.counters["centers"] = static_cast<double>(answer.centers);
    state.counters["points"] = static_cast<double>(answer.points);
  })->UseRealTime();
}

/// Down to which accuracy a way ends within a minute; the table's explanation names what is left out.
int finestDigits(const Problem& problem, const std::string& way)
{
  if (problem.is_square || way == "paper, our verdicts")
    return FINEST_DIGITS;
  return way == "paper, polynomial as written" ? 0 : FINEST_DIGITS - 1;
}

void addRowsOf(const Problem& problem, int digits)
{
  addWay(problem, digits, OURS, 5, [problem](double accuracy) { return byOurWay(problem, accuracy); });
  for (const auto& [way, classify] : paperTests(problem.machine))
    if (digits <= finestDigits(problem, way))
      addWay(problem, digits, way, 1,
             [problem, classify = classify](double accuracy) { return byPaper(problem, classify, accuracy); });
  addWay(problem, digits, "list, Boost.Interval, eigenvalues", 3,
         [problem](double accuracy) { return byList(problem, ListWay::EIGENVALUES, accuracy); });
  addWay(problem, digits, "list, Boost.Interval, minors", 3,
         [problem](double accuracy) { return byList(problem, ListWay::MINORS, accuracy); });
}
}  // namespace

void addLargestRows()
{
  for (const Problem& problem : { orthoglideCube(), uranesxSquare() })
    for (int digits = 2; digits <= FINEST_DIGITS; ++digits)
      addRowsOf(problem, digits);
}
}  // namespace bench
}  // namespace pkm_workspace
