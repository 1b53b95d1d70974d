#include "tests/support/program.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace rt;
using tests::rtlang;
using tests::TestFolder;

TEST_CASE("rtlang lint: text, JSON and exit codes") {
  const TestFolder folder;
  folder.write("good.rtl", "sphere {}\nsize: [40, 30]\n");
  folder.write("bad.rtl", "spare = box {}\nsphere {}\nsize: [40, 30]\n");
  folder.write("wrong.rtl", "sphere { raduis: 2 }\n");
  tests::RunOptions options;
  options.folder = folder.path();
  CHECK(rtlang({"lint", "good.rtl"}, options).output == "no warnings\n");
  CHECK(rtlang({"lint", "good.rtl", "--strict"}, options).exit_code == 0);
  const auto bad = rtlang({"lint", "bad.rtl"}, options);
  CHECK(bad.exit_code == 0);
  CHECK(bad.errors.empty());
  CHECK(bad.output.find("warning[W0101]: `spare` is bound and never placed\n  --> bad.rtl:1:1\n") == 0);
  CHECK(bad.output.find("\n1 warning; see `rtlang explain W0101`\n") != std::string::npos);
  CHECK(rtlang({"lint", "bad.rtl", "--strict"}, options).exit_code == 1);
  CHECK(rtlang({"lint", "bad.rtl", "--strict", "--allow", "never_placed"}, options).exit_code == 0);
  const auto json = nlohmann::json::parse(rtlang({"lint", "bad.rtl", "--json"}, options).output);
  REQUIRE(json.size() == 1);
  CHECK(json[0]["code"] == "W0101");
  CHECK(json[0]["line"] == 1);
  CHECK(json[0]["severity"] == "warning");
  const auto wrong = rtlang({"lint", "wrong.rtl"}, options);
  CHECK(wrong.exit_code == 1);
  CHECK(wrong.errors.find("error[E0204]") != std::string::npos);
  CHECK(wrong.output.empty());
  const auto unknown = rtlang({"lint", "good.rtl", "--allow", "hiden"}, options);
  CHECK(unknown.exit_code == 2);
  CHECK(unknown.errors.find("did you mean `hidden`?") != std::string::npos);
  CHECK(rtlang({"lint"}, options).exit_code == 2);
  CHECK(rtlang({"lint", "--rules"}).output.find("W0207  hidden            A thing is hidden by another\n") !=
        std::string::npos);
}
