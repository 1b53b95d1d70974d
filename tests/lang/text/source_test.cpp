#include "lang/text/source.hpp"

#include <catch2/catch.hpp>

using namespace rt::lang;

TEST_CASE("source: positions count lines and characters from 1") {
  SourceMap sources;
  const FileId file = sources.add("a.rtl", "", "ab\ncd\n");
  const auto at = [&](std::uint32_t offset) {
    const Position p = sources.position(file, offset);
    return std::pair(p.line, p.column);
  };
  CHECK(at(0) == std::pair(1u, 1u));
  CHECK(at(1) == std::pair(1u, 2u));
  CHECK(at(2) == std::pair(1u, 3u));
  CHECK(at(3) == std::pair(2u, 1u));
  CHECK(at(6) == std::pair(3u, 1u));
}

TEST_CASE("source: columns count characters, not bytes, and not the byte order mark") {
  SourceMap sources;
  const FileId file = sources.add("a.rtl", "",
                                  "\xef\xbb\xbf"
                                  "aé日x");
  CHECK(sources.position(file, 3).column == 1);
  CHECK(sources.position(file, 4).column == 2);
  CHECK(sources.position(file, 6).column == 3);
  CHECK(sources.position(file, 9).column == 4);
  CHECK(sources.line(file, 1) == "aé日x");
}

TEST_CASE("source: a line comes without its ending, of Unix or of Windows") {
  SourceMap sources;
  const FileId file = sources.add("a.rtl", "", "one\r\ntwo\n\nlast");
  CHECK(sources.line(file, 1) == "one");
  CHECK(sources.line(file, 2) == "two");
  CHECK(sources.line(file, 3).empty());
  CHECK(sources.line(file, 4) == "last");
}

TEST_CASE("source: a file knows where it was included from, the first one knows itself") {
  SourceMap sources;
  const FileId first = sources.add("a.rtl", "", "include \"b.rtl\"");
  const FileId second = sources.add("b.rtl", "", "", Span{first, 0, 15});
  CHECK(sources.file(first).included_from.file == first);
  CHECK(sources.file(second).included_from.file == first);
  CHECK(sources.text({first, 8, 15}) == "\"b.rtl\"");
}
