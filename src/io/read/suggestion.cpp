#include "phrame/io/read/suggestion.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace phrame::inline v0 {
namespace {

std::string letters(std::string_view word) {
  std::string result;
  for (const char c : word)
    if (c != '-' && c != '_')
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Optimal string alignment: Levenshtein's distance with swaps of neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> above(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(above, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, above[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

/// The smaller the nearer; no value where the two have little in common.
std::optional<std::size_t> distance(const std::string& word, const std::string& name) {
  if (word.empty() || name.empty()) return std::nullopt;
  const auto [shorter, longer] = std::minmax({word.size(), name.size()});
  const std::size_t lengths = longer - shorter;
  constexpr std::size_t more = 100;  // than what is nearer in kind
  if (shorter >= 3 && name.starts_with(word)) return lengths;
  const std::size_t edits = edit_distance(word, name);
  if (edits <= std::max<std::size_t>(1, longer / 3) && edits < shorter) return more + edits;
  const bool is_part = name.find(word) != std::string::npos || word.find(name) != std::string::npos;
  if (is_part && shorter >= 3) return 2 * more + lengths;
  return std::nullopt;
}

}  // namespace

std::optional<std::string> suggestion(std::string_view word,
                                      const std::vector<std::string>& names) {
  constexpr std::size_t longest = 60;
  if (word.size() > longest) return std::nullopt;
  std::optional<std::string> best;
  std::size_t least = 0;
  for (const std::string& name : names) {
    const auto found = distance(letters(word), letters(name));
    if (!found || (best && *found >= least)) continue;
    best = name;
    least = *found;
  }
  return best;
}

}  // namespace phrame
