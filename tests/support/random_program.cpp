#include "tests/support/random_program.hpp"

#include <utility>

namespace rt::tests {

namespace {

/// Parts that are drawn at random are drawn from left to right in braces; between + every compiler has an order of its
/// own.
std::string in_order(std::initializer_list<std::string> parts) {
  std::string out;
  for (const std::string& part : parts) out += part;
  return out;
}

} // namespace

std::string RandomProgram::pick(std::initializer_list<const char*> words) {
  return words.begin()[below(static_cast<int>(words.size()))];
}

std::string RandomProgram::gap() {
  if (parentheses_ > 0 && chance(5)) return chance(50) ? "\n" : " // " + comment() + "\n";
  if (chance(3)) return " /* " + comment() + " */ ";
  return chance(60) ? "" : chance(80) ? " " : "  ";
}

std::string RandomProgram::space() {
  const std::string blank = gap();
  return blank.empty() ? " " : blank;
}

std::string RandomProgram::continuation() {
  if (!chance(6)) return space();
  return chance(70) ? "\n  " : " // " + comment() + "\n";
}

std::string RandomProgram::separator(bool is_list) {
  switch (below(is_list ? 6 : 9)) {
  case 0:
  case 1:
  case 2:
    return ", ";
  case 3:
    return gap() + "\n";
  case 4:
    return "," + gap() + "\n";
  case 5:
    return chance(50) ? " // " + comment() + "\n" : ", // " + comment() + "\n";
  case 6:
    return "\n\n\n";
  case 7:
    return in_order(
        {"\n// ", comment(), "\n", chance(30) ? "\n" : "", chance(50) ? "/* " + comment() + "\n more */\n" : ""});
  default:
    return ";";
  }
}

std::string RandomProgram::text(int items) {
  std::string out = "\n";
  for (int i = 0; i < items; ++i) {
    if (chance(15)) out += "// " + comment() + "\n";
    out += item(3);
    out += chance(60) ? "\n" : chance(50) ? "\n\n\n" : chance(50) ? " // " + comment() + "\n" : "; ";
  }
  return out;
}

std::string RandomProgram::item(int depth) {
  switch (below(14)) {
  case 0:
  case 1:
    return in_order({name(), gap(), "=", continuation(), expression(depth)});
  case 2:
  case 3:
  case 4:
    return in_order({name(), gap(), ":", continuation(), expression(depth)});
  case 5:
    return depth > 0 ? in_order({"def ", name(), gap(), parameters(depth - 1), gap(), block(depth - 1)}) : name();
  case 6:
    return in_order(
        {"fn ", name(), gap(), parameters(depth - 1), gap(),
         depth > 0 && chance(30) ? block(depth - 1, true) : in_order({"=", continuation(), expression(depth - 1)})});
  case 7:
    return depth > 0 ? choice(depth - 1, false) : name();
  case 8:
    return depth > 0 ? in_order({"for", space(), loop(depth - 1), gap(), block(depth - 1)}) : name();
  case 9:
    return chance(50) ? "include \"a b.rtl\"" : "use" + space() + "\"lib.rtl\" as lib";
  case 10:
    return in_order(
        {"param ", name(), " = ", expression(0), chance(50) ? in_order({" in 1", gap(), "..", gap(), "10"}) : ""});
  default:
    return thing(depth);
  }
}

std::string RandomProgram::thing(int depth) {
  std::string out = in_order({name(), gap(), depth > 0 ? block(depth - 1) : "{" + gap() + "}"});
  for (int i = below(3); i > 0; --i) {
    if (parentheses_ == 0 && chance(40)) out += chance(70) ? "\n  " : "\n// " + comment() + "\n";
    out += in_order({".", pick({"move", "rotate", "scale"}), call(depth - 1)});
  }
  return out;
}

std::string RandomProgram::block(int depth, bool is_value) {
  const int outer = std::exchange(parentheses_, 0);
  std::string out = "{";
  if (chance(10)) out += " // " + comment() + "\n";
  out += chance(20) ? "\n" : gap();
  const int items = is_value ? below(2) : below(4);
  for (int i = 0; i < items; ++i) {
    out += is_value ? in_order({name(), " = ", expression(depth - 1)}) : item(depth - 1);
    if (i + 1 < items || is_value) out += separator(false);
  }
  if (is_value) out += "(" + expression(depth - 1) + ")";
  if (chance(20))
    out += separator(false);
  else if (chance(10))
    out += "\n// " + comment() + "\n";
  parentheses_ = outer;
  const bool is_comma_alone = items == 0 && !is_value;
  if (is_comma_alone) return chance(50) ? "{}" : "{ // " + comment() + "\n}";
  return out + gap() + "}";
}

std::string RandomProgram::literal() {
  switch (below(8)) {
  case 0:
    return "#f80";
  case 1:
    return "\"a // b\\n{ \\\" é\"";
  case 2:
    return pick({"true", "false", "none"});
  case 3:
    return pick({"30deg", "0.5turn", "1e-3", "2.5E2", ".5", "5.", "7.e2"});
  default:
    return in_order({std::to_string(below(100)), chance(40) ? "." + std::to_string(below(1000)) : ""});
  }
}

std::string RandomProgram::expression(int depth) {
  if (depth > 0 && chance(6)) return choice(depth - 1, true);
  if (depth > 0 && chance(4))
    return in_order({"fn", gap(), parameters(depth - 1), gap(), "=>", continuation(), expression(depth - 1)});
  std::string out = operand(depth);
  for (int i = chance(35) ? 1 + below(3) : 0; i > 0 && depth > 0; --i) {
    out += in_order(
        {space(), pick({"+", "-", "*", "/", "%", "|", "&", "^", "and", "or"}), continuation(), operand(depth - 1)});
  }
  return out;
}

std::string RandomProgram::operand(int depth) {
  const std::string sign = chance(10) ? pick({"-", "- ", "+", "+ "}) : "";
  if (depth <= 0) return sign + (chance(50) ? literal() : name());
  switch (below(10)) {
  case 0:
    return in_order({sign, name(), call(depth - 1)});
  case 1:
    return in_order({sign, name(), gap(), "[", on_lines(depth - 1), "]"});
  case 2:
    return list(depth - 1);
  case 3:
    return comprehension(depth - 1);
  case 4: {
    ++parentheses_;
    std::string out = in_order({sign, "(", gap(), expression(depth - 1), gap(), ")"});
    --parentheses_;
    return out + (chance(20) ? " " + block(depth - 1) : "");
  }
  case 5:
    return in_order({"{", name(), ": ", on_lines(depth - 1), ", b: 2 }"});
  case 6:
    return in_order({sign, name(), ".", name()});
  case 7:
    return chance(50) ? thing(depth - 1) : "(0" + pick({"..", "..<", " .. "}) + "n - 1 by 2 == [1])";
  default:
    return sign + (chance(60) ? literal() : name());
  }
}

std::string RandomProgram::on_lines(int depth) {
  const int outer = std::exchange(parentheses_, 0);
  std::string out = in_order({gap(), expression(depth), gap()});
  parentheses_ = outer;
  return out;
}

std::string RandomProgram::list(int depth) {
  const int outer = std::exchange(parentheses_, 0);
  std::string out = "[" + (chance(15) ? std::string("\n") : gap());
  const int length = chance(10) ? 40 : below(5);
  for (int i = 0; i < length; ++i) {
    out += length == 40 ? literal() : expression(depth);
    if (i + 1 < length) out += length == 40 ? "," : separator(true);
  }
  if (length > 0 && chance(20)) out += separator(true);
  parentheses_ = outer;
  return out + gap() + "]";
}

std::string RandomProgram::comprehension(int depth) {
  const int outer = std::exchange(parentheses_, 0);
  std::string out = in_order({"[", gap(), expression(depth)});
  out += in_order({chance(30) ? "\n" : space(), "for", space(), loop(depth)});
  if (chance(40)) out += in_order({chance(30) ? "\n" : space(), "if", space(), operand(depth)});
  parentheses_ = outer;
  return out + gap() + "]";
}

std::string RandomProgram::call(int depth) {
  ++parentheses_;
  std::string out = "(" + gap();
  const int length = below(4);
  for (int i = 0; i < length; ++i) {
    out += in_order({chance(30) ? in_order({name(), gap(), ":", gap()}) : "", expression(depth)});
    if (i + 1 < length || chance(10)) out += in_order({gap(), ",", gap()});
  }
  --parentheses_;
  return out + ")";
}

std::string RandomProgram::parameters(int depth) {
  ++parentheses_;
  std::string out = "(" + gap();
  const int length = below(3);
  for (int i = 0; i < length; ++i) {
    out += "p" + std::to_string(i) + (chance(50) ? in_order({gap(), "=", gap(), expression(depth - 1)}) : "");
    if (i + 1 < length) out += "," + gap();
  }
  --parentheses_;
  return out + ")";
}

std::string RandomProgram::choice(int depth, bool is_value) {
  std::string out =
      in_order({"if", space(), "a", space(), "<", space(), "(", operand(0), ")", gap(), block(depth, is_value)});
  if (chance(30)) out += in_order({gap(), "else", space(), "if", space(), "b", gap(), block(depth, is_value)});
  if (is_value || chance(50)) out += in_order({gap(), "else", gap(), block(depth, is_value)});
  return out;
}

std::string RandomProgram::loop(int depth) {
  return in_order({chance(30) ? in_order({"i", gap(), ",", gap()}) : "", "x", space(), "in", space(),
                   chance(50) ? in_order({"0", gap(), "..<", gap(), "9 by 3"}) : list(depth)});
}

} // namespace rt::tests
