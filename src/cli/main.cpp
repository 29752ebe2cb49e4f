#include "phrame/cli/run_program.hpp"

int main(int argc, char** argv) { return phrame::cli::run_program(argc, argv); }
