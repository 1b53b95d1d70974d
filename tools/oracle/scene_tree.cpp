#include "tools/oracle/scene_tree.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::tools::oracle {
namespace {

class Printer {
public:
  std::string file(const Block& block) {
    members(block);
    return std::move(out_);
  }

private:
  void line(const std::string& text) { out_ += std::string(2 * depth_, ' ') + text + '\n'; }

  void members(const Block& block) {
    for (const Prop& prop : block.props) {
      if (prop.block.empty())
        line(fmt::format("{}: {}", prop.name, prop.text));
      else
        statement(prop.name + ": ", prop.block.front());
    }
    for (const Block& thing : block.things) statement("", thing);
  }

  // A block that starts in the middle of a line.
  void statement(const std::string& before, const Block& block) {
    out_ += std::string(2 * depth_, ' ') + before;
    expression(block);
    out_ += '\n';
  }

  void expression(const Block& block) {
    if (block.operation.empty()) {
      out_ += block.head;
      braces(block, true);
    } else {
      out_ += '(';
      for (std::size_t i = 0; i < block.things.size(); ++i) {
        if (i > 0) out_ += fmt::format(" {} ", block.operation);
        expression(block.things[i]);
      }
      out_ += ')';
      if (!block.props.empty()) braces(block, false);
    }
    for (const std::string& step : block.chain) out_ += step;
  }

  void braces(const Block& block, bool with_things) {
    out_ += " {";
    if (!block.props.empty() || (with_things && !block.things.empty())) {
      out_ += '\n';
      ++depth_;
      Block inner;
      inner.props = block.props;
      if (with_things) inner.things = block.things;
      members(inner);
      --depth_;
      out_ += std::string(2 * depth_, ' ');
    }
    out_ += '}';
  }

  std::string out_;
  std::size_t depth_ = 0;
};

std::size_t size(const Block& block) {
  std::size_t n = 1 + block.props.size() + block.chain.size();
  for (const Block& thing : block.things) n += size(thing);
  for (const Prop& prop : block.props)
    for (const Block& value : prop.block) n += size(value);
  return n;
}

// Calls `emit` after each way of removing one part from `block`, which is restored afterwards.
void each_removal(Block& block, const std::function<void()>& emit) {
  const auto without = [&](auto& list, std::size_t i) {
    auto removed = std::move(list[i]);
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
    emit();
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(i), std::move(removed));
  };
  const bool keeps_two = !block.operation.empty() && block.things.size() <= 2;
  for (std::size_t i = 0; i < block.things.size() && !keeps_two; ++i) without(block.things, i);
  for (std::size_t i = 0; i < block.things.size() && !block.is_definition; ++i) {
    // A composite is replaced by one of its parts.
    if (block.head.empty() && block.operation.empty()) break;
    Block part = block.things[i];
    std::swap(block, part);
    emit();
    std::swap(block, part);
  }
  for (std::size_t i = 0; i < block.props.size(); ++i) without(block.props, i);
  for (std::size_t i = 0; i < block.chain.size(); ++i) without(block.chain, i);
  for (Block& thing : block.things) each_removal(thing, emit);
  for (Prop& prop : block.props)
    for (Block& value : prop.block) each_removal(value, emit);
}

} // namespace

std::string print(const Block& file) {
  return Printer().file(file);
}

std::string text(double value) {
  return fmt::format("{:.5g}", value == 0 ? 0.0 : value);
}

std::string text(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", text(v.x), text(v.y), text(v.z));
}

std::vector<Block> smaller(const Block& file) {
  std::vector<Block> all;
  Block copy = file;
  each_removal(copy, [&] { all.push_back(copy); });
  std::stable_sort(all.begin(), all.end(), [](const Block& a, const Block& b) { return size(a) < size(b); });
  return all;
}

Block minimise(Block file, const std::function<bool(const Block&)>& fails, int tries) {
  for (bool found = true; found;) {
    found = false;
    for (Block& candidate : smaller(file)) {
      if (tries-- <= 0) return file;
      if (!fails(candidate)) continue;
      file = std::move(candidate);
      found = true;
      break;
    }
  }
  return file;
}

} // namespace rt::tools::oracle
