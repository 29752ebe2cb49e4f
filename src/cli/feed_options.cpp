#include "phrame/cli/feed_options.hpp"

#include "phrame/algebra/as_written.hpp"
#include "phrame/io/read/feedrate.hpp"

namespace phrame::inline v0::cli {
namespace {

std::optional<Rational> limit_of(const char* option, const std::optional<std::string>& text) {
  if (!text) return std::nullopt;
  const Rational value = parse_option(option, *text);
  if (value <= 0) throw InputError(option, as_written(value) + " is not positive");
  return value;
}

Rational end_speed_of(const char* option, const std::optional<std::string>& text) {
  const Rational value = text ? parse_option(option, *text) : Rational(0);
  if (value < 0) throw InputError(option, as_written(value) + " is negative");
  return value;
}

}  // namespace

void FeedOptions::add_to(Command& command, const std::string& help) {
  command.add_option("--feed", "EXPR", feed, help);
  command.add_option("--max-normal-acceleration", "A", normal,
                     "kappa v^2 <= A: the speed v is the greatest one under V and the limits");
  command.add_option("--max-tangential-acceleration", "A", tangential,
                     "|dv/dt| <= A likewise, from rest to rest");
  command.add_option("--start-speed", "V", start_speed, "v at the start (default 0)");
  command.add_option("--end-speed", "V", end_speed, "v at the end (default 0)");
  command.only_with({"--start-speed", "--end-speed"}, {"--max-tangential-acceleration"});
}

Feedrate FeedOptions::feedrate() const {
  Feedrate found = at_place("--feed", ", ", [&] { return parse_feedrate(*feed); });
  found.limits.normal = limit_of("--max-normal-acceleration", normal);
  found.limits.tangential = limit_of("--max-tangential-acceleration", tangential);
  found.limits.start_speed = end_speed_of("--start-speed", start_speed);
  found.limits.end_speed = end_speed_of("--end-speed", end_speed);
  return found;
}

}  // namespace phrame::cli
