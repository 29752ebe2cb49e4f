#include "phrame/io/write/twist_frame_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame {
namespace {

/// Where it cannot be told from 0, 0 with the radius that is known, by a precision for `digits`.
Decimal rounded_or_zero(const Real& x, const std::string& what, long digits, long shown_digits) {
  const long most_bits = 14 * digits + 128;
  try {
    return round_to_decimal(x, shown_digits, {0, most_bits});
  } catch (const Undecided& undecided) {
    const RealBall ball = x.enclose(most_bits);
    if (!ball.is_finite() || !ball.contains_zero()) throw Undecided(what + ": " + undecided.what());
    return {"0", upper_bound_text(std::max(Rational(-ball.lower()), ball.upper()))};
  }
}

Decimal rounded_or_zero(const Real& x, const std::string& what, long digits) {
  return rounded_or_zero(x, what, digits, digits);
}

/// The parameter of the curve at an inflection of a piece.
Real inflection_at(const RationalTwist& twist, const RealBall& found) {
  return Real([twist, found](long bits) {
    const long precision = bits + 32;
    const auto& narrow = twist.inflections(precision).at;
    const auto same = std::find_if(narrow.begin(), narrow.end(),
                                   [&](const RealBall& tau) { return tau.overlaps(found); });
    const TwistPiece& piece = twist.piece();
    const RealBall width(piece.to - piece.from, precision);
    return add(RealBall(piece.from, precision),
               multiply(width, same == narrow.end() ? found : *same, precision), precision);
  });
}

constexpr long few = 6;  // digits in a table

ErrorSize error_size(const Real& number, const std::string& what, long digits) {
  const Real x = remembered(number);
  const Decimal value = rounded_or_zero(x, what, digits);
  if (value.value == "0" && value.radius != "0")
    return {{value.radius, value.radius}, "≤ " + value.radius, true};
  return {value, rounded_or_zero(x, what, std::max(digits, few), few).value};
}

TwistPieceReport piece_report(const MinimalTwist& mtf, const BestTwist& best, long digits) {
  const RationalTwist& twist = best.twist;
  const TwistPiece& piece = twist.piece();
  const auto decimal = [digits](const Real& x, const std::string& what) {
    return rounded(x, what, digits);
  };
  const auto& [index, t] = locate(mtf.spline(), piece.from);
  const auto size = [&](const Real& x, const std::string& what, long to_digits) {
    return error_size(relative_error(x, mtf, piece.length), what, to_digits);
  };
  const Real gamma = remembered(twist.end_factor());
  const SignChanges inflections = twist.inflections(4 * digits + 64);
  TwistPieceReport report{piece.from,
                          piece.to,
                          2 * preimage_degree(mtf.spline().segments()[index]) + 2 * twist.degree(),
                          twist.degree(),
                          decimal(gamma, "gamma"),
                          rounded(gamma, "gamma", few).value,
                          {},
                          best.doubt,
                          {},
                          twist.extra_turns(),
                          size(twist.root_mean_square(), "the root mean square", digits),
                          size(twist.greatest_error(), "the greatest error", digits),
                          is_monotone(inflections),
                          {},
                          {}};
  if (best.minimum) {
    const Rational& radius = best.minimum->radius;
    report.proved = {{upper_bound_text(radius), upper_bound_text(twist.end_factor_change(radius)),
                      !best.minimum->is_for_both_signs}};
  }
  for (const auto& [re, im] : twist.coefficients())
    report.coefficients.emplace_back(rounded_or_zero(re, "a coefficient of w", digits),
                                     rounded_or_zero(im, "a coefficient of w", digits));
  for (const RealBall& tau : inflections.at)
    report.inflections.push_back(decimal(inflection_at(twist, tau), "an inflection"));
  if (best.other) {  // only a guess is known
    const long known = std::min(digits, few);
    report.other = {rounded(best.other->end_factor(), "gamma", known),
                    size(best.other->root_mean_square(), "the root mean square", known)};
  }
  return report;
}

std::string shown(const Decimal& x) { return (x.radius == "0" ? "= " : "≈ ") + x.value; }

/// With its unit, where it is not 0.
std::string shown(const ErrorSize& x, std::string_view unit) {
  if (x.value.value == "0") return "= 0";
  return (x.is_bound ? "≤ " + x.value.value : shown(x.value)) + std::string(unit);
}

std::string shown(const std::pair<Decimal, Decimal>& z) {
  const auto& [re, im] = z;
  const bool is_negative = im.value.starts_with('-');
  return fmt::format("{} {} {}i", re.value, is_negative ? "−" : "+",
                     is_negative ? im.value.substr(1) : im.value);
}

std::string inflections_text(const TwistPieceReport& piece) {
  std::string text;
  for (const Decimal& t : piece.inflections)
    text += (text.empty() ? ", it changes at t ≈ " : ", ") + t.value;
  return text;
}

/// "+ 2π", "− 4π".
std::string turns_text(const Integer& turns) {
  return fmt::format("{} {}π", turns < 0 ? "−" : "+", Integer(2 * abs(turns)).str());
}

std::string in_detail(const TwistPieceReport& piece, std::string_view unit) {
  constexpr std::size_t width = 31;
  std::string text;
  for (std::size_t k = 0; k < piece.coefficients.size(); ++k)
    text += row(fmt::format("w{}", k), "≈ " + shown(piece.coefficients[k]), width);
  text += row("γ, of w(1) = γ exp(iθ(1)/2)", shown(piece.gamma), width);
  if (piece.proved)
    text += row("proved",
                fmt::format("the least rms{} is that of one w, with coefficients within {}",
                            piece.proved->is_of_one_sign ? " with this sign of γ" : "",
                            piece.proved->radius),
                width);
  else if (!piece.doubt.empty())
    text += row("not proved to be the best", piece.doubt, width);
  if (piece.other)
    text += row(
        "with the other sign of γ",
        fmt::format("γ ≈ {}, rms {}", piece.other->first.value, shown(piece.other->second, unit)),
        width);
  text += row("rms of Ω₁ − Ω̄₁", shown(piece.root_mean_square, unit), width);
  text += row("greatest |Ω₁ − Ω̄₁|", shown(piece.greatest, unit), width);
  text += row("Ω₁ has one sign", std::string(to_string(piece.monotone)) + inflections_text(piece),
              width);
  if (piece.extra_turns != 0)
    text += row("it turns by", "T " + turns_text(piece.extra_turns), width);
  return text;
}

/// "0", "3/7", or eight digits.
std::string place(const Rational& t) {
  return to_string(t).size() < 9 ? to_string(t) : round_to_decimal(t, 8).value;
}

/// A line for each reason why pieces are not proved to be the best, and where.
std::string doubts(const std::vector<TwistPieceReport>& pieces) {
  std::vector<std::pair<std::string, std::vector<const TwistPieceReport*>>> reasons;
  for (const TwistPieceReport& piece : pieces) {
    if (piece.proved || piece.doubt.empty()) continue;
    auto known = std::find_if(reasons.begin(), reasons.end(),
                              [&](const auto& reason) { return reason.first == piece.doubt; });
    if (known == reasons.end()) known = reasons.insert(known, {piece.doubt, {}});
    known->second.push_back(&piece);
  }
  if (reasons.empty()) return "  Each w is proved to be the best one.\n";
  std::string text;
  for (const auto& [doubt, here] : reasons) {
    std::string where;
    for (const TwistPieceReport* piece : here)
      where += fmt::format("{}{} to {}", where.empty() ? ", from t = " : ", ", place(piece->from),
                           place(piece->to));
    text += fmt::format("  No proof that w is the best one{}: {}\n",
                        here.size() == pieces.size() ? "" : where, doubt);
  }
  return text;
}

/// A line for each piece.
std::string table(const std::vector<TwistPieceReport>& pieces) {
  std::string text = fmt::format("  {:<12}{:<12}{:<4}{:<12}{:<14}{:<14}{}\n", "from t", "to t", "n",
                                 "γ", "rms", "greatest", "one sign");
  for (const TwistPieceReport& piece : pieces)
    text += fmt::format(
        "  {:<12}{:<12}{:<4}{:<12}{:<14}{:<14}{}{}\n", place(piece.from), place(piece.to),
        piece.rotation_degree, piece.gamma_in_short, piece.root_mean_square.in_short,
        piece.greatest.in_short, to_string(piece.monotone),
        piece.extra_turns == 0 ? "" : ", turns by T " + turns_text(piece.extra_turns));
  return text;
}

}  // namespace

TwistFrameReport twist_frame_report(const MinimalTwist& mtf, const TwistFrame& frame, long digits) {
  TwistFrameReport report{{},
                          error_size(relative_error(root_mean_square(frame), mtf, mtf.length()),
                                     "the root mean square", digits),
                          Monotone::undecided,
                          mtf.twist().exact() != Rational(0)};
  for (const BestTwist& piece : frame.pieces)
    report.pieces.push_back(piece_report(mtf, piece, digits));
  report.monotone = is_monotone(frame);  // by the inflections of the pieces, known now
  return report;
}

std::string to_text(const TwistFrameReport& report) {
  const std::string_view unit = report.is_relative ? " |Ω̄₁|" : "/S";
  const auto& pieces = report.pieces;
  if (pieces.size() == 1) {
    return fmt::format(
               "\nA rational frame of degree {}: θ(t) = 2 arg w(t), w of degree {} with the "
               "Bernstein coefficients\n",
               pieces.front().frame_degree, pieces.front().rotation_degree) +
           in_detail(pieces.front(), unit);
  }
  std::string text =
      fmt::format("\nA rational frame in {} pieces: θ = 2 arg w, w of degree n, errors of Ω₁{}\n",
                  pieces.size(), report.is_relative ? " over |Ω̄₁|" : " times S");
  text += table(pieces);
  std::string details;
  for (std::size_t k = 0; k < pieces.size(); ++k)
    details += fmt::format("\n  Piece {}\n{}", k + 1, in_detail(pieces[k], unit));
  text += passage(details + "\n", "  … and the coefficients of each w\n");
  text += doubts(pieces);
  text += row("rms of Ω₁ − Ω̄₁, all pieces", shown(report.root_mean_square, unit), 31);
  text += row("Ω₁ has one sign", std::string(to_string(report.monotone)), 31);
  return text;
}

}  // namespace phrame
