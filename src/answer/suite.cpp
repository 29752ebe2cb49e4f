#include "phrame/answer/suite.hpp"

#include <algorithm>

#include "phrame/ph/along/reduced_angle.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long suite_bits = 64;

/// Of the frames at the ends of a closed path, reduced to one turn.
std::optional<RealBall> holonomy_error(const CheckAnswer& table) {
  const Path& path = table.path.path;
  if (!path.is_closed()) return std::nullopt;
  std::optional<RealBall> first;
  std::optional<RealBall> last;
  for (std::size_t k = 0; k < table.frames.size(); ++k) {
    if (table.frames[k].t == 0) first = table.verdict.errors[k];
    if (table.frames[k].t == path.end()) last = table.verdict.errors[k];
  }
  if (!first || !last) return std::nullopt;
  return reduced(subtract(*last, *first, suite_bits), suite_bits);
}

std::size_t flips_of(const FrameVerdict& verdict) {
  std::size_t count = 0;
  for (const FrameFinding& finding : verdict.findings)
    if (finding.kind == FrameFinding::Kind::flip) count += finding.samples.size();
  return count;
}

void take_larger(std::optional<Rational>& most, const std::optional<RealBall>& x) {
  if (!x) return;
  const Rational size = absolute(*x).upper();
  most = most ? std::max(*most, size) : size;
}

std::optional<double> median(std::vector<double> numbers) {
  if (numbers.empty()) return std::nullopt;
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

SuiteGroup group_of(const std::string& name, const std::vector<const SuiteRow*>& rows) {
  SuiteGroup group{name};
  std::vector<double> orders;
  for (const SuiteRow* row : rows) {
    ++group.curves;
    if (!row->failure.empty()) {
      ++group.failures;
      continue;
    }
    group.passed += row->passes ? 1 : 0;
    group.flips += row->flips;
    take_larger(group.max_error, row->max_error);
    take_larger(group.drift, row->drift);
    take_larger(group.holonomy, row->holonomy);
    if (const auto seconds = row->seconds()) {
      group.seconds = group.seconds.value_or(0) + *seconds;
      group.timed_samples += row->samples;
    }
    if (const auto& order = row->convergence.order) orders.push_back(approximate(*order));
  }
  group.order = median(std::move(orders));
  return group;
}

}  // namespace

SuiteRow suite_row(const std::string& name, const std::string& group,
                   const std::vector<SuiteTable>& tables) {
  std::vector<StepError> steps;
  const CheckAnswer* finest = nullptr;
  Rational least;
  for (const auto& [table, seconds] : tables) {
    steps.push_back(step_error(table.frames, table.verdict));
    steps.back().seconds = seconds;
    if (finest == nullptr || steps.back().step <= least) {
      finest = &table;
      least = steps.back().step;
    }
  }
  const FrameVerdict& verdict = finest->verdict;
  return {name,
          group,
          "",
          verdict.passes,
          finest->frames.size(),
          verdict.max_error,
          flips_of(verdict),
          verdict.orthogonality,
          verdict.drift,
          holonomy_error(*finest),
          convergence(std::move(steps))};
}

std::optional<Rational> SuiteRow::seconds() const {
  return convergence.steps.empty() ? std::nullopt : convergence.steps.back().seconds;
}

bool SuiteAnswer::passes() const {
  return missing.empty() &&
         std::all_of(rows.begin(), rows.end(), [](const SuiteRow& row) { return row.passes; });
}

std::vector<SuiteGroup> suite_groups(const SuiteAnswer& answer) {
  std::vector<SuiteGroup> groups;
  std::vector<const SuiteRow*> all;
  for (auto row = answer.rows.begin(); row != answer.rows.end();) {
    std::vector<const SuiteRow*> of_group;
    const std::string& name = row->group;
    for (; row != answer.rows.end() && row->group == name; ++row) of_group.push_back(&*row);
    groups.push_back(group_of(name, of_group));
    all.insert(all.end(), of_group.begin(), of_group.end());
  }
  groups.push_back(group_of("", all));
  return groups;
}

}  // namespace phrame
