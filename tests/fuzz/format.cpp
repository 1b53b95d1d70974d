// Whatever parses is formatted faithfully, and formatting again changes nothing. Run as fuzz_parse is.

#include "lang/format/format.hpp"

#include "lang/syntax/parse.hpp"

#include <cstdint>
#include <cstdlib>

namespace {

using namespace rt::lang;

std::string formatted(const std::string& text) {
  SourceMap sources;
  const Formatted out = format(sources, sources.add("fuzz.rtl", "", text));
  if (!out.diagnostics.empty() && out.text != text) std::abort();
  return out.text;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // What is not faithful is given back as it was; blanks in front, which no layout keeps, tell that case apart.
  const std::string text = "\n \n" + std::string(data, data + size);
  SourceMap sources;
  SymbolTable symbols;
  if (!parse(sources, sources.add("fuzz.rtl", "", text), symbols).diagnostics.empty()) return 0;
  const std::string once = formatted(text);
  if (once == text || formatted(once) != once) std::abort();
  return 0;
}
