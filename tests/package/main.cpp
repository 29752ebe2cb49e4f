#include "phrame/version.hpp"

int main() { return phrame::version.empty() ? 1 : 0; }
