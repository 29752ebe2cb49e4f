#include "phrame/io/write/twist_frame.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/io/write/text.hpp"

namespace phrame {
namespace {

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

std::string inflections_text(const TwistPieceAnswer& piece) {
  std::string text;
  for (const Decimal& t : piece.inflections)
    text += (text.empty() ? ", it changes at t ≈ " : ", ") + t.value;
  return text;
}

/// "+ 2π", "− 4π".
std::string turns_text(const Integer& turns) {
  return fmt::format("{} {}π", turns < 0 ? "−" : "+", Integer(2 * abs(turns)).str());
}

std::string in_detail(const TwistPieceAnswer& piece, std::string_view unit) {
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
std::string doubts(const std::vector<TwistPieceAnswer>& pieces) {
  std::vector<std::pair<std::string, std::vector<const TwistPieceAnswer*>>> reasons;
  for (const TwistPieceAnswer& piece : pieces) {
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
    for (const TwistPieceAnswer* piece : here)
      where += fmt::format("{}{} to {}", where.empty() ? ", from t = " : ", ", place(piece->from),
                           place(piece->to));
    text += fmt::format("  No proof that w is the best one{}: {}\n",
                        here.size() == pieces.size() ? "" : where, doubt);
  }
  return text;
}

/// A line for each piece.
std::string table(const std::vector<TwistPieceAnswer>& pieces) {
  std::string text = fmt::format("  {:<12}{:<12}{:<4}{:<12}{:<14}{:<14}{}\n", "from t", "to t", "n",
                                 "γ", "rms", "greatest", "one sign");
  for (const TwistPieceAnswer& piece : pieces)
    text += fmt::format(
        "  {:<12}{:<12}{:<4}{:<12}{:<14}{:<14}{}{}\n", place(piece.from), place(piece.to),
        piece.rotation_degree, piece.gamma_in_short, piece.root_mean_square.in_short,
        piece.greatest.in_short, to_string(piece.monotone),
        piece.extra_turns == 0 ? "" : ", turns by T " + turns_text(piece.extra_turns));
  return text;
}

}  // namespace

std::string to_text(const TwistFrameAnswer& answer) {
  const std::string_view unit = answer.is_relative ? " |Ω̄₁|" : "/S";
  const auto& pieces = answer.pieces;
  if (pieces.size() == 1) {
    return fmt::format(
               "\nA rational frame of degree {}: θ(t) = 2 arg w(t), w of degree {} with the "
               "Bernstein coefficients\n",
               pieces.front().frame_degree, pieces.front().rotation_degree) +
           in_detail(pieces.front(), unit);
  }
  std::string text =
      fmt::format("\nA rational frame in {} pieces: θ = 2 arg w, w of degree n, errors of Ω₁{}\n",
                  pieces.size(), answer.is_relative ? " over |Ω̄₁|" : " times S");
  text += table(pieces);
  std::string details;
  for (std::size_t k = 0; k < pieces.size(); ++k)
    details += fmt::format("\n  Piece {}\n{}", k + 1, in_detail(pieces[k], unit));
  text += passage(details + "\n", "  … and the coefficients of each w\n");
  text += doubts(pieces);
  text += row("rms of Ω₁ − Ω̄₁, all pieces", shown(answer.root_mean_square, unit), 31);
  text += row("Ω₁ has one sign", std::string(to_string(answer.monotone)), 31);
  return text;
}

}  // namespace phrame
