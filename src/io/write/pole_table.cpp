#include "phrame/io/write/pole_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/rounding.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

std::string text_of(const PolePart& part) {
  constexpr long digits = 12;
  const RealBall& x = part.ball;
  if (part.is_known) return to_string(x, digits);
  return fmt::format("(|·| < {})", upper_bound_text(std::max(x.upper(), Rational(-x.lower()))));
}

/// "0.1 ± 0.2i", the lower sign being that of the conjugate.
std::string text_of(const PolePart& re, const PolePart& im) {
  std::string size = text_of(im);
  const bool negative = size.starts_with('-');
  if (negative) size.erase(0, 1);
  return size == "0" ? text_of(re)
                     : fmt::format("{} {} {}i", text_of(re), negative ? "∓" : "±", size);
}

}  // namespace

std::vector<PoleTexts> texts_of(const PoleTable& table) {
  std::vector<PoleTexts> texts;
  for (const PoleRow& row : table.rows)
    texts.push_back({text_of(row.re, row.im), text_of(row.residue_re, row.residue_im)});
  return texts;
}

std::string to_text(const PoleTable& table) {
  if (table.rows.empty())
    return "\n  " + passage("", fmt::format("⟨{} poles and their residues⟩", table.poles)) + "\n";
  const std::vector<PoleTexts> texts = texts_of(table);
  std::vector<std::string> poles{"pole z"};
  for (const PoleTexts& row : texts) poles.push_back(with_minus_sign(row.pole));
  poles = aligned(poles);
  std::string text = fmt::format("\n  {}   residue c(z)\n", poles.front());
  for (std::size_t k = 0; k < texts.size(); ++k)
    text += fmt::format("  {}   {}\n", poles[k + 1], with_minus_sign(texts[k].residue));
  return text;
}

}  // namespace phrame
