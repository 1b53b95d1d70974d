#include "lang/syntax/repeat_folder.hpp"

#include "lang/text/literals.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rt::lang {

namespace {

constexpr std::uint32_t shortest_block = 16; // not worthwhile for shorter blocks
constexpr std::size_t most_models = 64;      // wordings that all differ are not worth keeping

// Kinds with neither a scope nor an order of their own.
bool is_plain(Kind kind) {
  switch (kind) {
  case Kind::property:
  case Kind::number:
  case Kind::string:
  case Kind::color:
  case Kind::boolean:
  case Kind::none:
  case Kind::name:
  case Kind::numbers:
  case Kind::list:
  case Kind::record:
  case Kind::call:
  case Kind::index:
  case Kind::member:
  case Kind::override_:
  case Kind::unary:
  case Kind::binary:
  case Kind::range:
  case Kind::block:
  case Kind::argument:
    return true;
  default:
    return false;
  }
}

// How `a` and `b` of a node are compared between two items.
enum class Slot : std::uint8_t { same, node, link, free };
struct Slots {
  Slot a, b;
};

Slots slots_of(Kind kind) {
  switch (kind) {
  case Kind::number:
  case Kind::color:
    return {Slot::free, Slot::free};
  case Kind::numbers:
    return {Slot::free, Slot::same};
  case Kind::string:
    return {Slot::free, Slot::same}; // compared by its content
  case Kind::list:
  case Kind::record:
  case Kind::block:
  case Kind::call:
    return {Slot::link, Slot::same};
  case Kind::property:
  case Kind::argument:
    return {Slot::same, Slot::node};
  case Kind::member:
    return {Slot::node, Slot::same};
  case Kind::range:
    return {Slot::node, Slot::link};
  case Kind::unary:
    return {Slot::node, Slot::same};
  case Kind::index:
  case Kind::override_:
  case Kind::binary:
    return {Slot::node, Slot::node};
  default:
    return {Slot::same, Slot::same};
  }
}

} // namespace

bool RepeatFolder::is_foldable(std::uint32_t first_node, std::uint32_t last_node) const {
  const std::vector<Node>& nodes = builder_.ast().nodes;
  return std::all_of(nodes.begin() + first_node, nodes.begin() + last_node + 1,
                     [](const Node& node) { return is_plain(node.kind); });
}

// A hash of the item's words in order: kinds, names, operators and lengths, but no literals and no positions.
std::uint64_t RepeatFolder::hash(const Model& item) const {
  const Ast& ast = builder_.ast();
  std::uint64_t hash = 0;
  const auto mix = [&](std::uint64_t word) { hash = (hash ^ word) * 0x9e3779b97f4a7c15u, hash ^= hash >> 29; };
  for (std::uint32_t n = item.first_node; n <= item.last_node; ++n) {
    const Node& node = ast.nodes[n];
    const Slots fields = slots_of(node.kind);
    std::uint64_t word = static_cast<std::uint64_t>(node.kind) << 8 | static_cast<std::uint64_t>(node.op);
    if (fields.a == Slot::same) word |= std::uint64_t{node.a} << 16;
    if (fields.b == Slot::same) word ^= std::uint64_t{node.b} << 40;
    mix(word);
  }
  return hash;
}

bool RepeatFolder::has_wording_of(const Model& item, const Model& model) const {
  if (item.last_node - item.first_node != model.last_node - model.first_node || item.links != model.links) return false;
  const Ast& ast = builder_.ast();
  const std::uint32_t node_shift = item.first_node - model.first_node;
  const std::uint32_t link_shift = item.first_link - model.first_link;
  const auto agree = [&](Slot field, std::uint32_t x, std::uint32_t y) {
    switch (field) {
    case Slot::same:
      return x == y;
    case Slot::node:
      return x - node_shift == y;
    case Slot::link:
      return x - link_shift == y;
    case Slot::free:
      break;
    }
    return true;
  };
  for (std::uint32_t n = model.first_node; n <= model.last_node; ++n) {
    const Node& a = ast.nodes[n + node_shift];
    const Node& b = ast.nodes[n];
    if (a.kind != b.kind || a.op != b.op) return false;
    if (a.kind == Kind::string && ast.strings[a.a] != ast.strings[b.a]) return false;
    const Slots fields = slots_of(a.kind);
    if (!agree(fields.a, a.a, b.a) || !agree(fields.b, a.b, b.b)) return false;
  }
  for (std::uint32_t i = 0; i < model.links; ++i) {
    const NodeId a = ast.links[item.first_link + i], b = ast.links[model.first_link + i];
    const bool is_equal = a == no_node || b == no_node
                              ? a == b
                              : static_cast<std::uint32_t>(a) - node_shift == static_cast<std::uint32_t>(b);
    if (!is_equal) return false;
  }
  return true;
}

void RepeatFolder::take_literals(const Model& item, std::vector<double>& literals) const {
  const Ast& ast = builder_.ast();
  literals.clear();
  for (std::uint32_t n = item.first_node; n <= item.last_node; ++n) {
    const NodeId id{n};
    if (ast.kind(id) == Kind::number) literals.push_back(ast.number(id));
    if (ast.kind(id) == Kind::color) literals.push_back(ast.color(id));
    if (ast.kind(id) != Kind::numbers) continue;
    const std::span<const double> numbers = ast.numbers(id);
    literals.insert(literals.end(), numbers.begin(), numbers.end());
  }
}

// The operand, an item, becomes a repeat of the model.
void RepeatFolder::begin_repeat(const Model& model, std::uint32_t operand, const std::vector<double>& literals,
                                bool is_first) {
  Ast& ast = builder_.ast();
  AstBuilder::Operand& item = builder_.operand(operand);
  const auto repeat = static_cast<std::uint32_t>(ast.repeats.size());
  ast.repeats.push_back({NodeId{model.last_node}, NodeId{model.first_node},
                         static_cast<std::uint32_t>(ast.constants.size()), static_cast<std::uint32_t>(literals.size()),
                         static_cast<std::uint32_t>(ast.repeat_spans.size()), 1, is_first});
  ast.constants.insert(ast.constants.end(), literals.begin(), literals.end());
  ast.repeat_spans.push_back({item.begin, item.end});
  item.node = NodeId{static_cast<std::uint32_t>(ast.nodes.size())};
  ast.nodes.push_back({Kind::repeat, Op{}, 0, item.begin, item.end, repeat, 0});
}

// The last operand joins the repeat that precedes it, if that is one of the same model with its literals at the
// end.
bool RepeatFolder::extend_repeat(const Model& model) {
  Ast& ast = builder_.ast();
  const NodeId before = builder_.operand(builder_.count() - 2).node;
  if (ast.kind(before) != Kind::repeat) return false;
  Repeat& repeat = ast.repeats[ast[before].a];
  const bool is_last = repeat.first_number + std::size_t{repeat.count} * repeat.numbers_each == ast.constants.size() &&
                       repeat.first_span + repeat.count == ast.repeat_spans.size();
  if (repeat.model != NodeId{model.last_node} || !is_last) return false;
  const AstBuilder::Operand item = builder_.pop();
  ast.constants.insert(ast.constants.end(), literals_.begin(), literals_.end());
  ast.repeat_spans.push_back({item.begin, item.end});
  ast[before].end = item.end;
  ++repeat.count;
  return true;
}

// From the text of the last operand, the first item that repeats the model; `literals_` are its own. If that is
// ambiguous, the model's items all go through the grammar.
void RepeatFolder::learn_wording(Model& model, std::string_view text) const {
  const AstBuilder::Operand& item = builder_.top();
  model.repeat_text = RepeatText::of(text.substr(item.begin, item.end - item.begin), literals_);
}

// Follows the text along one model; where it departs from that for another, all models left earlier are out.
std::optional<std::uint32_t> RepeatFolder::repeat_item(std::string_view text, std::uint32_t begin) {
  const std::span<const Model> models = known_models();
  static_assert(most_models <= 64);
  std::uint64_t candidates = 0; // a bit for each model; all agree with one another on the first `agreed` pieces
  for (std::size_t i = 0; i < models.size(); ++i) candidates |= std::uint64_t{models[i].repeat_text.has_value()} << i;
  std::size_t agreed = 0;
  const Model* model = nullptr;
  std::uint32_t at = begin;
  literals_.clear();
  for (;;) {
    const std::size_t number = literals_.size();
    const std::string_view rest = text.substr(at);
    const auto goes_on = [&](const RepeatText& w) {
      return number <= w.numbers() && rest.starts_with(w.piece(number));
    };
    if (!model || !goes_on(*model->repeat_text)) {
      const Model* next = nullptr;
      for (std::uint64_t left = candidates; left != 0; left &= left - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(left));
        const RepeatText& w = *models[i].repeat_text;
        if (!goes_on(w) || (model && !w.agrees(*model->repeat_text, agreed, number)))
          candidates &= ~(std::uint64_t{1} << i);
        else if (!next)
          next = &models[i];
      }
      if (!next) return std::nullopt;
      model = next;
      agreed = number + 1;
    }
    at += static_cast<std::uint32_t>(model->repeat_text->piece(number).size());
    if (number == model->repeat_text->numbers()) break;
    const NumberLiteral literal = read_signed_number(text.substr(at));
    if (literal.length == 0 || std::isinf(literal.value)) return std::nullopt; // not a number, or one with an error
    literals_.push_back(literal.value);
    at += literal.length;
  }
  if (!ends_item(text, at)) return std::nullopt;
  builder_.nothing(begin);
  AstBuilder::Operand& item = builder_.top();
  item.end = at;
  item.depth = builder_.operand(model->operand).depth;
  if (!extend_repeat(*model)) begin_repeat(*model, builder_.count() - 1, literals_, false);
  return at;
}

void RepeatFolder::finish_item(const AstBuilder::Snapshot& before, std::optional<std::string_view> text) {
  Ast& ast = builder_.ast();
  const Block& block = blocks_.back();
  const NodeId node = builder_.top().node;
  const Kind kind = ast.kind(node);
  if (is_declaration(kind)) return forget_models();
  if (kind != Kind::override_ && kind != Kind::call) return;
  const std::size_t known = models_.size() - block.first_model;
  if (known == 0 && builder_.count() - block.first_operand < shortest_block) return;
  Model item{0,
             static_cast<std::uint32_t>(before.nodes),
             static_cast<std::uint32_t>(node),
             static_cast<std::uint32_t>(before.links),
             static_cast<std::uint32_t>(ast.links.size() - before.links),
             builder_.count() - 1};
  const bool is_whole = item.last_node + 1 == ast.nodes.size();
  if (!is_whole || !is_foldable(item.first_node, item.last_node)) return;
  item.hash = hash(item);
  Model* const model = find(item.hash);
  if (model == nullptr) {
    if (known >= most_models) forget_models();
    models_.push_back(item);
    return;
  }
  if (!has_wording_of(item, *model)) return;
  take_literals(item, literals_);
  builder_.truncate_arena(before);
  if (!model->is_repeated) {
    model->is_repeated = true;
    std::vector<double> own;
    take_literals(*model, own);
    begin_repeat(*model, model->operand, own, true);
    if (text) learn_wording(*model, *text);
  }
  if (!extend_repeat(*model)) begin_repeat(*model, builder_.count() - 1, literals_, false);
}

RepeatFolder::Model* RepeatFolder::find(std::uint64_t hash) {
  for (std::size_t i = models_.size(); i > blocks_.back().first_model; --i) {
    if (models_[i - 1].hash == hash) return &models_[i - 1];
  }
  return nullptr;
}

} // namespace rt::lang
