#include "tools/rtlang/program.hpp"

#include <string>
#include <vector>

int main(int argc, char** argv) { return rt::tools::run(std::vector<std::string>(argv + 1, argv + argc)); }
