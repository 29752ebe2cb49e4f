#include "phrame/io/write/twist_frame.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {
namespace {

std::string in_words(Monotone monotone) {
  return monotone == Monotone::yes ? "yes" : monotone == Monotone::no ? "no" : "undecided";
}

std::string decimal(const std::string& x, Notation notation) {
  return notation == Notation::latex ? latex_decimal(x) : with_minus_sign(x);
}

/// With its unit, where it is not 0.
std::string compared(const ErrorSize& x, std::string_view unit, Notation notation) {
  if (x.value.value == "0") return formula("= 0", notation);
  const char* const relation = x.is_bound ? "≤" : x.value.radius == "0" ? "=" : "≈";
  return formula(fmt::format("{} {}{}", relation, decimal(x.value.value, notation), unit),
                 notation);
}

std::string compared(const std::pair<Decimal, Decimal>& z, Notation notation) {
  const auto& [re, im] = z;
  const bool is_negative = im.value.starts_with('-');
  return formula(fmt::format("≈ {} {} {}i", decimal(re.value, notation), is_negative ? "−" : "+",
                             decimal(is_negative ? im.value.substr(1) : im.value, notation)),
                 notation);
}

/// "+ 2π", "− 4π".
std::string turns_text(const Integer& turns) {
  return fmt::format("{} {}π", turns < 0 ? "−" : "+", Integer(2 * abs(turns)).str());
}

JsonOutput json_of(const ErrorSize& x) {
  if (x.is_bound) return {{"at_most", x.value.value}};
  return phrame::json_of(x.value);
}

JsonOutput json_of(Monotone monotone) {
  if (monotone == Monotone::undecided) return "undecided";
  return monotone == Monotone::yes;
}

/// What errors are measured by: in words, and in the keys of JSON.
struct Unit {
  std::string words;
  std::string suffix;
};

Unit unit_of(const TwistFrameAnswer& answer) {
  return answer.is_relative ? Unit{" |Ω̄₁|", "_relative"} : Unit{"/S", "_times_length"};
}

Value error_value(const ErrorSize& x, const Unit& unit) {
  return {Value::Words([&x, unit](Notation notation) { return compared(x, unit.words, notation); }),
          [&x] { return json_of(x); }};
}

/// The coefficients of w, in words a row each.
Field coefficients_field(const TwistPieceAnswer& piece) {
  Fields parts;
  for (std::size_t k = 0; k < piece.coefficients.size(); ++k) {
    const auto words = [&z = piece.coefficients[k]](Notation notation) {
      return compared(z, notation);
    };
    parts.push_back({"", fmt::format("$w_{{{}}}$", k), {Value::Words(words), {}}});
  }
  const auto json = [](const auto& w) -> JsonOutput {
    return {{"re", phrame::json_of(w.first)}, {"im", phrame::json_of(w.second)}};
  };
  return {"w",
          "",
          {Value::Rows(), [&piece, json] { return array_of(piece.coefficients, json); }},
          parts};
}

/// Is w proved to be the best, or why not? No words, where there are none for that.
Field optimum_field(const TwistPieceAnswer& piece) {
  const auto rows = [&piece](Notation notation) -> std::vector<std::string> {
    if (!piece.proved && piece.doubt.empty()) return {};
    if (!piece.proved) return {piece.doubt};
    return {fmt::format("the least rms{} is that of one $w$, with coefficients within {}",
                        piece.proved->is_of_one_sign ? " with this sign of $γ$" : "",
                        formula(decimal(piece.proved->radius, notation), notation))};
  };
  const auto json = [&piece]() -> JsonOutput {
    if (!piece.proved) return {{"proved", false}, {"reason", piece.doubt}};
    return {{"proved", true},
            {"radius", piece.proved->radius},
            {"gamma_radius", piece.proved->gamma},
            {"of_one_sign", piece.proved->is_of_one_sign}};
  };
  return {
      "optimum", piece.proved ? "proved" : "not proved to be the best", {Value::Rows(rows), json}};
}

/// The best w with the other sign of γ, where there is one.
Field other_field(const TwistPieceAnswer& piece, const Unit& unit) {
  if (!piece.other) return {};
  const auto words = [&other = *piece.other, unit](Notation notation) {
    return fmt::format("$γ ≈$ {}, rms {}", formula(decimal(other.first.value, notation), notation),
                       compared(other.second, unit.words, notation));
  };
  const auto json = [&other = *piece.other, unit] {
    return JsonOutput{{"gamma", phrame::json_of(other.first)},
                      {"rms" + unit.suffix, json_of(other.second)}};
  };
  return {"other_branch", "with the other sign of $γ$", {Value::Words(words), json}};
}

Field monotone_field(const TwistPieceAnswer& piece) {
  const auto words = [&piece](Notation notation) {
    std::string places;
    for (const Decimal& t : piece.inflections)
      places += (places.empty() ? ", it changes at $t ≈$ " : ", ") +
                formula(decimal(t.value, notation), notation);
    return in_words(piece.monotone) + places;
  };
  return {"monotone", "$Ω₁$ has one sign", {Value::Words(words), [&piece] {
                                              return json_of(piece.monotone);
                                            }}};
}

Field turns_field(const TwistPieceAnswer& piece) {
  const auto words = [&piece](Notation notation) {
    return formula("T " + turns_text(piece.extra_turns), notation);
  };
  return {"extra_turns",
          piece.extra_turns == 0 ? "" : "it turns by",
          {Value::Words(words), [&piece] { return piece.extra_turns.str(); }}};
}

Fields fields(const TwistPieceAnswer& piece, const Unit& unit) {
  const JsonOutput inflections =
      array_of(piece.inflections, [](const Decimal& t) { return t.value; });
  const Field gamma{"gamma", "$γ$, of $w(1) = γ \\exp(iθ(1)/2)$", compared_value(piece.gamma)};
  const Field optimum = optimum_field(piece);
  const Field other = other_field(piece, unit);
  return {json_field("from", to_string(piece.from)),
          json_field("to", to_string(piece.to)),
          json_field("degree", piece.frame_degree),
          json_field("rotation_degree", piece.rotation_degree),
          in_json(gamma),
          coefficients_field(piece),
          out_of_json(gamma),
          out_of_json(optimum),
          out_of_json(other),
          {"rms" + unit.suffix, "rms of $Ω₁ − Ω̄₁$", error_value(piece.root_mean_square, unit)},
          {"greatest" + unit.suffix, "greatest $|Ω₁ − Ω̄₁|$", error_value(piece.greatest, unit)},
          monotone_field(piece),
          json_field("inflections", inflections),
          turns_field(piece),
          in_json(optimum),
          in_json(other)};
}

/// "0", "3/7", or eight digits.
std::string place(const Rational& t) {
  const std::string exact = to_string(t);
  return with_minus_sign(exact.size() < 9 ? exact : round_to_decimal(t, 8).value);
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
        piece.greatest.in_short, in_words(piece.monotone),
        piece.extra_turns == 0 ? "" : ", turns by T " + turns_text(piece.extra_turns));
  return text;
}

/// What a frame of one piece is.
std::string opening(const TwistPieceAnswer& piece) {
  return fmt::format(
      "\nA rational frame of degree {}: $θ(t) = 2 \\arg w(t)$, $w$ of degree {} with the "
      "Bernstein coefficients\n",
      piece.frame_degree, piece.rotation_degree);
}

}  // namespace

Value compared_value(const Decimal& x) {
  const auto words = [x](Notation notation) {
    return formula((x.radius == "0" ? "= " : "≈ ") + decimal(x.value, notation), notation);
  };
  return {Value::Words(words), [x] { return json_of(x); }};
}

Fields fields(const TwistFrameAnswer& answer) {
  const bool is_one = answer.pieces.size() == 1;  // of which the words say it already
  const Unit unit = unit_of(answer);
  const auto pieces = [&answer, unit] {
    return array_of(answer.pieces, [&unit](const TwistPieceAnswer& piece) {
      return json_of(fields(piece, unit));
    });
  };
  const auto monotone = [&answer](Notation) { return in_words(answer.monotone); };
  return {{"rational", "", {Value::Rows(), pieces}},
          {"rms" + unit.suffix, is_one ? "" : "rms of $Ω₁ − Ω̄₁$, all pieces",
           error_value(answer.root_mean_square, unit)},
          {"monotone", is_one ? "" : "$Ω₁$ has one sign", {Value::Words(monotone), [&answer] {
                                                             return json_of(answer.monotone);
                                                           }}}};
}

std::string to_text(const TwistFrameAnswer& answer) {
  const Unit unit = unit_of(answer);
  const auto& pieces = answer.pieces;
  if (pieces.size() == 1)
    return prose(opening(pieces.front()), Notation::unicode) +
           to_rows(fields(pieces.front(), unit), 31);
  std::string text =
      fmt::format("\nA rational frame in {} pieces: θ = 2 arg w, w of degree n, errors of Ω₁{}\n",
                  pieces.size(), answer.is_relative ? " over |Ω̄₁|" : " times S");
  text += table(pieces);
  std::string details;
  for (std::size_t k = 0; k < pieces.size(); ++k)
    details += fmt::format("\n  Piece {}\n{}", k + 1, to_rows(fields(pieces[k], unit), 31));
  text += passage(details + "\n", "  … and the coefficients of each w\n");
  return text + doubts(pieces) + to_rows(fields(answer), 31);
}

std::string to_latex(const TwistFrameAnswer& answer) {
  constexpr auto latex = Notation::latex;
  const Unit unit = unit_of(answer);
  const auto& pieces = answer.pieces;
  if (pieces.size() == 1)
    return prose(opening(pieces.front()), latex) + to_align(fields(pieces.front(), unit));
  std::string text;
  for (std::size_t k = 0; k < pieces.size(); ++k)
    text += fmt::format("\nPiece {}, from $t = {}$ to ${}$.\n{}", k + 1,
                        formatted(pieces[k].from, latex), formatted(pieces[k].to, latex),
                        prose(opening(pieces[k]), latex) + to_align(fields(pieces[k], unit)));
  return text + "\nAll pieces:\n" + to_align(fields(answer));
}

}  // namespace phrame
