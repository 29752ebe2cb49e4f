#include "phrame/algebra/spool.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>

#include <doctest/doctest.h>

using namespace phrame;

namespace {

/// Numbers as text, more than a megabyte.
std::string many_bytes() {
  std::string bytes;
  for (int k = 0; k < 400'000; ++k) bytes += std::to_string(k);
  return bytes;
}

void append_in_pieces(Spool& spool, const std::string& bytes) {
  for (std::size_t k = 0; k < bytes.size(); k += 777)
    spool.append([&](std::string& last) { last += bytes.substr(k, 777); });
}

std::string all_of(const Spool& spool) {
  std::string bytes;
  spool.read([&](const std::string& block) { bytes += block; });
  return bytes;
}

}  // namespace

TEST_CASE("spool: what is appended is read again, more than once, and goes on") {
  const std::string bytes = many_bytes();
  REQUIRE(bytes.size() > std::size_t{2} << 20);
  for (const auto new_spool : {Spool::with_file, Spool::in_memory}) {
    Spool spool = new_spool();
    CHECK(all_of(spool).empty());
    append_in_pieces(spool, bytes);
    CHECK(spool.size() == bytes.size());
    CHECK(all_of(spool) == bytes);
    CHECK(all_of(spool) == bytes);
    append_in_pieces(spool, bytes);
    CHECK(spool.size() == 2 * bytes.size());
    CHECK(all_of(spool) == bytes + bytes);
  }
}

TEST_CASE("spool: where no file can be made, all is in memory") {
  const char* before = std::getenv("TMPDIR");
  const std::string old = before == nullptr ? "" : before;
  setenv("TMPDIR", "/nowhere/at/all", 1);
  Spool spool = Spool::with_file();
  const std::string bytes = many_bytes();
  append_in_pieces(spool, bytes);
  CHECK(all_of(spool) == bytes);
  if (old.empty())
    unsetenv("TMPDIR");
  else
    setenv("TMPDIR", old.c_str(), 1);
}
