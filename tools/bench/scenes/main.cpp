#include "tools/bench/scenes/layout.hpp"

#include <exception>
#include <fstream>
#include <iostream>
#include <map>

// Writes one of the measured scenes to standard output.
int main(int argc, char** argv) {
  using namespace rt::tools::bench;
  const std::map<std::string_view, Format> formats = {
      {"rtl", Format::rtl}, {"pov", Format::povray}, {"tachyon", Format::tachyon}};
  if (argc != 3 || !formats.contains(argv[2])) {
    std::cerr << "usage: bench_scenes SCENE rtl|pov|tachyon\nscenes:";
    for (const std::string_view name : layout_names) std::cerr << ' ' << name;
    std::cerr << '\n';
    return 2;
  }
  try {
    std::cout << write(make_layout(argv[1]), formats.at(argv[2])) << std::flush;
    return std::cout ? 0 : 3;
  } catch (const std::exception& error) {
    std::cerr << "bench_scenes: " << error.what() << '\n';
    return 2;
  }
}
