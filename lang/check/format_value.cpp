#include "lang/check/program.hpp"
#include "lang/text/literals.hpp"
#include "lang/values/thing.hpp"
#include "lang/values/value.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rt::lang {
namespace {

std::string format_color(const Color& color) {
  const auto channel = [](double linear) { return linear_to_srgb(linear) * 255; };
  const double r = channel(color.r), g = channel(color.g), b = channel(color.b);
  const auto is_byte = [](double v) { return v > -0.5 && v < 255.5 && std::abs(v - std::round(v)) < 1e-6; };
  if (is_byte(r) && is_byte(g) && is_byte(b))
    return fmt::format("#{:02x}{:02x}{:02x}", std::lround(r), std::lround(g), std::lround(b));
  return fmt::format("linear_rgb({}, {}, {})", format_number(color.r), format_number(color.g), format_number(color.b));
}

std::string format_range(const Value& value) {
  const RangeValue& r = value.range();
  std::string text =
      fmt::format("{}{}{}", format_number(r.from), value.excludes_end() ? "..<" : "..", format_number(r.to));
  if (r.step != 1) text += " by " + format_number(r.step);
  return text;
}

std::string format_fade(const scene::Fade& fade) {
  switch (fade.law) {
  case scene::Fade::Law::none:
    return "none";
  case scene::Fade::Law::linear:
    return fmt::format("linear({})", format_number(fade.distance));
  case scene::Fade::Law::quadratic:
    return fmt::format("quadratic({})", format_number(fade.distance));
  case scene::Fade::Law::inverse_square:
    return "inverse_square";
  }
  return "";
}

void append(std::string& out, const Value& value, const SymbolTable& names);

void append_list(std::string& out, const Value& value, const SymbolTable& names) {
  out += '[';
  for (std::size_t i = 0, n = sequence_size(value); i < n; ++i) {
    if (i > 0) out += ", ";
    append(out, sequence_at(value, i), names);
  }
  out += ']';
}

void append_record(std::string& out, const Record& record, const SymbolTable& names) {
  out += "{ ";
  for (std::size_t i = 0; i < record.entries.size(); ++i) {
    if (i > 0) out += ", ";
    (out += names.name(record.entries[i].name)) += ": ";
    append(out, record.entries[i].value, names);
  }
  out += " }";
}

void append_thing(std::string& out, const Thing& thing, const SymbolTable& names) {
  out += thing.def ? names.name(thing.def->name) : thing.type->name;
  out += " {";
  bool is_first = true;
  for (const PropertyValue& p : thing.properties) {
    const bool is_parameter = (p.id & parameter_bit) != 0;
    out += is_first ? " " : ", ";
    is_first = false;
    if (is_parameter)
      out += names.name(thing.def->parameters[p.id ^ parameter_bit].name);
    else
      out += thing.type->properties[p.id].name;
    out += ": ";
    append(out, p.value, names);
  }
  if (!thing.def && thing.content) out += is_first ? " …" : ", …";
  out += is_first && !thing.content ? "}" : " }";
}

void append(std::string& out, const Value& value, const SymbolTable& names) {
  switch (value.kind()) {
  case ValueKind::none:
    out += "none";
    return;
  case ValueKind::boolean:
    out += value.truth() ? "true" : "false";
    return;
  case ValueKind::number:
    out += format_number(value.number());
    return;
  case ValueKind::vector:
  case ValueKind::list:
    append_list(out, value, names);
    return;
  case ValueKind::color:
    out += format_color(value.color());
    return;
  case ValueKind::range:
    out += format_range(value);
    return;
  case ValueKind::fade:
    out += format_fade(value.fade());
    return;
  case ValueKind::choice:
    out += value.choice();
    return;
  case ValueKind::string:
    out += write_string(value.text());
    return;
  case ValueKind::record:
    append_record(out, value.record(), names);
    return;
  case ValueKind::thing:
    append_thing(out, value.thing(), names);
    return;
  case ValueKind::closure:
    out += value.closure().function->name == no_symbol ? "fn" : names.name(value.closure().function->name);
    out += "(…)";
    return;
  default:
    out += describe(value);
    return;
  }
}

} // namespace

std::string format(const Value& value, const SymbolTable& names) {
  std::string out;
  append(out, value, names);
  return out;
}

} // namespace rt::lang
