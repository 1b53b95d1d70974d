#include "lang/ide/hover.hpp"

#include "lang/ide/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <variant>

namespace rt::lang {
namespace {

/// The first line of an item.
std::string first_line(std::string_view text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return std::string(text);
  const std::string_view line = text.substr(0, text.find_last_not_of(" \t\r\n", end) + 1);
  return fmt::format("{} …", line);
}

/// The comments directly above an item, without their `//`, a line each.
std::string comments_above(const SourceMap& sources, Span item) {
  std::string comments;
  std::uint32_t line = sources.position(item.file, item.begin).line;
  while (line-- > 1) {
    std::string_view text = sources.line(item.file, line);
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    if (!text.starts_with("//")) break;
    text.remove_prefix(text.starts_with("// ") ? 3 : 2);
    comments = fmt::format("\n  {}", text) + comments;
  }
  return comments;
}

class Describer {
public:
  explicit Describer(const Program& program) : program_(program) {}

  std::string operator()(DeclarationId id) const {
    const Declaration& d = program_.references[id];
    const std::string_view word = program_.symbols.name(d.symbol);
    const Span item = d.unit->ast.span(d.item);
    switch (d.what) {
    case Declaration::What::parameter:
      return fmt::format("{}: a parameter of\n  {}", word, first_line(program_.sources.text(item)));
    case Declaration::What::local:
      return fmt::format("{}: known in\n  {}", word, first_line(program_.sources.text(item)));
    case Declaration::What::unknown:
      return fmt::format("{}: the line that declares it is in error", word);
    default:
      return first_line(program_.sources.text(item)) + comments_above(program_.sources, item);
    }
  }
  std::string operator()(FileId file) const { return program_.sources.file(file).name; }
  std::string operator()(const NodeType* type) const {
    const auto entry = find_entry(type->name);
    return entry ? describe(*entry) : std::string(type->name);
  }
  std::string operator()(const Property* property) const { return describe_property(*property); }
  std::string operator()(const Builtin* builtin) const {
    return fmt::format("{}({})\n  {}", builtin->name, builtin->signature.text(), builtin->help);
  }
  std::string operator()(const SignatureParameter* parameter) const {
    const std::string_view otherwise = parameter->default_text;
    return fmt::format("{}: {}{}{}", parameter->name, parameter->types_text, otherwise.empty() ? "" : " = ", otherwise);
  }
  std::string operator()(const ChainMethod* method) const {
    return fmt::format("thing.{}({})\n  {}", method->name, method->signature.text(), method->help);
  }
  std::string operator()(const Constant* constant) const {
    return fmt::format("{} = {}\n  {}", constant->name, constant->value_text, constant->help);
  }
  std::string operator()(const ColorName& color) const { return fmt::format("{} = #{:06x}", color.word, color.rgb); }
  std::string operator()(const Choice& choice) const {
    for (const NodeType& type : program_.types.all())
      for (const Property& property : type.properties)
        if (std::ranges::find(property.choices, choice.word) != property.choices.end())
          return describe_property(property);
    return std::string(choice.word);
  }

private:
  const Program& program_;
};

} // namespace

std::optional<Hover> hover(const Analysis& analysis, FileId file, std::uint32_t place) {
  const Reference* reference = analysis.program->references.at(file, place);
  if (!reference) return std::nullopt;
  return Hover{reference->span, std::visit(Describer(*analysis.program), reference->referent)};
}

} // namespace rt::lang
