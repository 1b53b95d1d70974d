#include "lang/ide/reference.hpp"
#include "lang/text/words.hpp"

#include <fmt/format.h>

namespace rt::lang {
namespace {

struct Form {
  std::string_view example, meaning;
};

Form form_of(Word word) {
  switch (word) {
  case Word::for_:
  case Word::in_:
    return {"for x in 0..5 { … }   for i, x in list { … }   [x * x for x in 0..5]",
            "once per element; things placed and properties set apply to the enclosing block, bindings are local"};
  case Word::by_:
    return {"0..1 by 0.25", "a range's step"};
  case Word::if_:
  case Word::else_:
    return {"if a > 1 { … } else { … }", "one block or the other; as a value it needs `else`"};
  case Word::def_:
    return {"def table(width = 2) { … }", "defines a thing, placed with `table { width: 3 }`"};
  case Word::fn_:
    return {"fn wave(a) = 0.3 * sin(a)   fn (x) => x * x", "a function, with a name or without"};
  case Word::use_:
  case Word::as_:
    return {"use \"shapes.rtl\" as shapes", "the names of another file, as in `shapes.vase`"};
  case Word::include_:
    return {"include \"shapes.rtl\"", "all of another file, in this place"};
  case Word::param_:
    return {"param height = 2 in 1..5", "a value that the command line may set: -D height=3"};
  case Word::and_:
  case Word::or_:
  case Word::not_:
    return {"a > 1 and not b or c", "true or false; `not` before `and` before `or`"};
  case Word::true_:
  case Word::false_:
    return {"true   false", "the two truth values"};
  case Word::none_:
    return {"none", "no value; as an item it places nothing"};
  case Word::expect_:
    return {"expect pixel(400, 300) hits ball   expect a ~ b", "a test run by `rtlang test`"};
  default:
    return {};
  }
}

} // namespace

std::string describe_keyword(std::string_view word) {
  const Form form = form_of(classify(word));
  return form.example.empty() ? "" : fmt::format("{}\n  {}\n", form.example, form.meaning);
}

} // namespace rt::lang
