#include "phrame/io/write/answers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/io/write/text.hpp"
#include "phrame/ph/proof/statement.hpp"

namespace phrame::inline v0 {
namespace {

struct Name {
  std::string operator()(const std::string& part) const { return part; }
  std::string operator()(const AngleClaim& claim) const {
    return name("theta", claim.t, claim.theta, claim.radius);
  }
  std::string operator()(const LengthClaim& claim) const {
    return name("length", claim.t, claim.length, claim.radius);
  }

 private:
  static std::string name(const char* of, const Rational& t, const std::string& value,
                          const std::string& radius) {
    constexpr std::size_t limit = 240;
    return fmt::format("|{}({}) - {}| <= {}", of, readable_exact(to_string(t), limit), value,
                       radius);
  }
};

}  // namespace

std::string to_text(const std::vector<Statement>& statements) {
  std::string text;
  for (const auto& [what, objection, segment] : statements) {
    std::string name = std::visit(Name{}, what);
    if (segment) name = fmt::format("segment {}: {}", *segment, name);
    text += objection.empty() ? fmt::format("proved      {}\n", name)
                              : fmt::format("not proved  {}: {}\n", name, objection);
  }
  return text + summary(statements) + "\n";
}

std::string summary(const std::vector<Statement>& statements) {
  const auto not_proved = std::count_if(statements.begin(), statements.end(),
                                        [](const Statement& s) { return !s.is_proved(); });
  return not_proved == 0 ? fmt::format("all {} statements are proved", statements.size())
                         : fmt::format("{} of {} statements {} not proved", not_proved,
                                       statements.size(), not_proved == 1 ? "is" : "are");
}

}  // namespace phrame
