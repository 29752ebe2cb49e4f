#pragma once
#include <string>

namespace phrame::inline v0::test {

/// The path of `name`, "/curves.jsonl", below tests/data, and of "/README.md" below the root. One
/// source file knows where these are (main.cpp), so that the objects of all others depend on
/// nothing but their text.
std::string data(const std::string& name);
std::string root(const std::string& name);

}  // namespace phrame::test
