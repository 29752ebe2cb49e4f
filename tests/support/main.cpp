#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "support/data.hpp"

namespace phrame::test {

std::string root(const std::string& name) { return PHRAME_ROOT + name; }
std::string data(const std::string& name) { return root("/tests/data" + name); }

}  // namespace phrame::test
