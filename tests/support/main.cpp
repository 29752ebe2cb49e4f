#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <iostream>

#include "support/data.hpp"
#include "support/skip.hpp"

namespace phrame::inline v0::test {
namespace {

bool is_skipped = false;

}  // namespace

std::string root(const std::string& name) { return PHRAME_ROOT + name; }
std::string data(const std::string& name) { return root("/tests/data" + name); }

void skip(const std::string& why) {
  std::cout << "not run: " << why << std::endl;
  is_skipped = true;
}

}  // namespace phrame::test

int main(int argc, char** argv) {
  const int status = doctest::Context(argc, argv).run();
  return status == 0 && phrame::test::is_skipped ? 77 : status;
}
