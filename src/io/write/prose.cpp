#include "phrame/io/write/prose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace phrame::inline v0 {
namespace {

using enum Notation;

struct Sign {
  std::string_view unicode;
  std::string_view latex;
};

/// In formulas, a longer one before those that it begins with.
constexpr Sign signs[] = {
    {"γ", "\\gamma"},      {"θ", "\\theta"},  {"κ", "\\kappa"},     {"λ", "\\lambda"},
    {"π", "\\pi"},         {"ρ", "\\rho"},    {"σ", "\\sigma"},     {"τ", "\\tau"},
    {"ϑ", "\\vartheta"},   {"φ", "\\varphi"}, {"ψ", "\\psi"},       {"ω", "\\omega"},
    {"Ω̄", "\\bar\\Omega"}, {"Ω", "\\Omega"},  {"ℚ", "\\mathbb{Q}"}, {"ℝ", "\\mathbb{R}"},
    {"ℤ", "\\mathbb{Z}"},  {"∞", "\\infty"},  {"∫", "\\int"},       {"√", "\\sqrt"},
    {"·", "\\cdot"},       {"×", "\\times"},  {"±", "\\pm"},        {"≈", "\\approx"},
    {"≤", "\\le"},         {"…", "\\dots"},   {"−", "-"},           {"′", "'"},
    {"″", "''"},           {"‴", "'''"},      {"*", "^*"},          {"⁰", "^0"},
    {"¹", "^1"},           {"²", "^2"},       {"ᵗ", "^t"},          {"₀", "_0"},
    {"₁", "_1"},           {"₂", "_2"},       {"₃", "_3"}};

/// In words. What LaTeX has a meaning for is escaped.
constexpr Sign characters[] = {{"–", "--"},
                               {"%", "\\%"},
                               {"#", "\\#"},
                               {"&", "\\&"},
                               {"_", "\\_"},
                               {"{", "\\{"},
                               {"}", "\\}"},
                               {"~", "\\textasciitilde{}"},
                               {"^", "\\textasciicircum{}"},
                               {"\\", "\\textbackslash{}"},
                               {"<", "$<$"},
                               {">", "$>$"}};

const Sign* sign_at(std::string_view text, const auto& table) {
  const auto* const found = std::find_if(std::begin(table), std::end(table), [&](const Sign& sign) {
    return text.starts_with(sign.unicode);
  });
  return found == std::end(table) ? nullptr : found;
}

/// What LaTeX needs around letters and signs, in formulas; a longer one before those that it begins
/// with.
constexpr std::string_view marks[] = {"\\,", "\\text", "\\", "_{", "{", "}"};

std::string in_unicode(std::string_view words) {
  std::string text;
  bool is_formula = false;
  while (!words.empty()) {
    const auto* const mark = std::find_if(std::begin(marks), std::end(marks),
                                          [&](std::string_view x) { return words.starts_with(x); });
    if (words.front() == '$') {
      is_formula = !is_formula;
      words.remove_prefix(1);
    } else if (is_formula && mark != std::end(marks)) {
      words.remove_prefix(mark->size());
    } else {
      text += words.front();
      words.remove_prefix(1);
    }
  }
  return text;
}

/// The name of a command ends where no letter follows.
bool needs_blank(std::string_view command, std::string_view after) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return is_letter(command.back()) && !after.empty() && is_letter(after.front());
}

std::string in_latex(std::string_view words) {
  const auto ends_with_relation = [](std::string_view formula) {
    return formula.ends_with("=") || formula.ends_with("\\approx");
  };
  std::string text;
  bool is_formula = false;
  while (!words.empty()) {
    const bool is_ascii = static_cast<unsigned char>(words.front()) < 0x80U;
    if (const Sign* const character = sign_at(words, characters); character && !is_formula) {
      text += character->latex;
      words.remove_prefix(character->unicode.size());
    } else if (const Sign* const sign = sign_at(words, signs); sign && (is_formula || !is_ascii)) {
      words.remove_prefix(sign->unicode.size());
      text += is_formula ? std::string(sign->latex) : fmt::format("${}$", sign->latex);
      if (is_formula && needs_blank(sign->latex, words)) text += ' ';
    } else if (words.starts_with("$ $") && ends_with_relation(text)) {  // one formula goes on
      text += ' ';
      words.remove_prefix(3);
    } else {
      if (words.front() == '$') is_formula = !is_formula;
      text += words.front();
      words.remove_prefix(1);
    }
  }
  return text;
}

}  // namespace

std::string prose(std::string_view words, Notation notation) {
  return notation == latex ? in_latex(words) : in_unicode(words);
}

std::string formula(const std::string& text, Notation notation) {
  return notation == latex ? "$" + text + "$" : text;
}

}  // namespace phrame
