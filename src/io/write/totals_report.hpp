#pragma once
#include <optional>

#include "phrame/answer/totals.hpp"
#include "phrame/ph/curve/named.hpp"

namespace phrame {

/// What `phrame totals` shows of a curve, the values rounded.
struct TotalsReport {
  struct Row {
    std::string key;     ///< in JSON
    std::string name;    ///< "length"
    std::string symbol;  ///< "∫ ds"
    std::optional<Total> total = std::nullopt;
    std::optional<Decimal> value = std::nullopt;
    std::optional<Infinite> infinite = std::nullopt;  ///< instead of a total
    std::string reason = {};                          ///< why there is neither
  };
  NamedCurve curve;
  std::vector<Row> rows;
  long digits;
};

/// Computes all totals to `digits` digits. Throws Undecided, naming the total, where one cannot be
/// rounded.
TotalsReport totals_report(const NamedCurve& curve, long digits);

std::string to_text(const TotalsReport& report);
std::string to_json(const TotalsReport& report);  ///< totals/1

}  // namespace phrame
