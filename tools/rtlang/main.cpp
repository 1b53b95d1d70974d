#include "tools/rtlang/program.hpp"

int main(int count, char** arguments) {
  return rt::tools::run({arguments + 1, arguments + count});
}
