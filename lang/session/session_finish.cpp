#include "lang/check/errors/shared_errors.hpp"
#include "lang/evaluate/deep_stack.hpp"
#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/session/session_change.hpp"
#include "lang/session/session_outcome.hpp"
#include "lang/session/session_text.hpp"
#include "lang/text/sort_unique.hpp"

#include <fmt/format.h>

#include <algorithm>

// The end of a change: fresh statements are checked and evaluated, and a new document is assembled.
namespace rt::lang {
std::optional<Document> SessionChange::finish() {
  if (core_.report.has_errors()) return std::nullopt;
  renew_dependents();
  if (core_.report.has_errors() || !check() || !evaluate()) return std::nullopt;
  take_out_printed();
  report_outcomes();
  settle_only(trait_camera);
  settle_only(trait_sky);
  report_dependents();
  check_scene_properties();
  if (core_.report.has_errors()) return std::nullopt;
  return assemble();
}

void SessionChange::report_outcomes() {
  for (const Reported& reported : reported_) {
    const auto at = find_id(reported.id);
    if (!at) continue; // it was printed
    const std::string outcome = outcome_of(entries_[*at].get(), reported.replaces, core_.evaluator, core_.program);
    if (!outcome.empty()) changes.push_back(outcome);
  }
}

void SessionChange::report_dependents() {
  constexpr std::size_t most = 4;
  for (std::size_t i = 0; i < std::min(renewed_.size(), most); ++i)
    changes.push_back(fmt::format("rebuilt: {}", renewed_[i]));
  if (renewed_.size() > most) changes.push_back(fmt::format("and {} more", renewed_.size() - most));
}

// Chunks in which nothing has changed are reused.
Document SessionChange::assemble() {
  DocumentBuilder builder;
  for (std::size_t i = 0; i < entries_.size();) {
    RevisedStatement& entry = entries_[i];
    if (entry.fresh) {
      builder.add(StatementRef(std::move(entry.fresh)));
      ++i;
      continue;
    }
    const std::vector<StatementRef>& statements = chunk_of(entry).statements;
    const bool may_share = entry.done == statements.data() && statements.size() >= DocumentBuilder::least_worth_sharing;
    std::size_t same = 0;
    while (may_share && same < statements.size() && i + same < entries_.size() && !entries_[i + same].fresh &&
           entries_[i + same].done == entry.done + same)
      ++same;
    if (may_share && same == statements.size()) {
      builder.add(old_.chunks()[entry.chunk]);
      i += same;
    } else {
      builder.add(*entry.done);
      ++i;
    }
  }
  return builder.finish();
}

// The symbols in the texts that are checked again; nothing if a file is included, whose text is not known yet.
std::optional<SessionChange::Mentioned> SessionChange::mentioned_by_fresh() const {
  Mentioned mentioned{std::vector<bool>(core_.program.symbols.size())};
  const Unit* last = nullptr;
  for (const RevisedStatement& entry : entries_) {
    if (!entry.fresh || entry.fresh->is_comment() || entry.fresh->unit == last) continue;
    last = entry.fresh->unit;
    for (const Node& node : last->ast.nodes) {
      if (node.kind == Kind::include) return std::nullopt;
      if (node.kind != Kind::name) continue;
      mentioned.symbols[node.a] = true;
      mentioned.bits |= symbol_bit(Symbol{node.a});
    }
  }
  return mentioned;
}

// Of the statements checked before, only those matter whose names the others mention.
bool SessionChange::check() {
  const std::optional<Mentioned> mentioned = mentioned_by_fresh();
  const auto matters = [&](const RevisedStatement& entry) {
    if (!mentioned) return true;
    if ((declared_bits(entry) & mentioned->bits) == 0) return false;
    const std::vector<TopName>& names = (*entry.done)->names;
    return std::any_of(names.begin(), names.end(),
                       [&](const TopName& name) { return mentioned->symbols[static_cast<std::size_t>(name.name)]; });
  };
  std::vector<TopItem> items;
  std::vector<Statement*> fresh; // of the items; null for those checked before
  for (const RevisedStatement& entry : entries_) {
    if (!entry.fresh) {
      if (!matters(entry)) continue;
      items.emplace_back().names = (*entry.done)->names;
      fresh.push_back(nullptr);
    } else if (!entry.fresh->is_comment()) {
      TopItem& item = items.emplace_back();
      item.unit = entry.fresh->unit;
      item.nodes = entry.fresh->nodes;
      fresh.push_back(entry.fresh.get());
    }
  }
  const auto further_names = [this](std::vector<std::string_view>& names) {
    for (const RevisedStatement& entry : entries_)
      if (!entry.fresh)
        for (const TopName& name : (*entry.done)->names) names.push_back(core_.program.symbols.name(name.name));
  };
  check_session(items, core_.slots, further_names, core_.program, core_.files, core_.report);
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!fresh[i]) continue;
    fresh[i]->names = std::move(items[i].names);
    fresh[i]->uses = std::move(items[i].uses);
    fresh[i]->globals = std::move(items[i].globals);
    sort_unique(fresh[i]->uses);
    sort_unique(fresh[i]->globals);
  }
  return !core_.report.has_errors();
}

bool SessionChange::evaluate() {
  std::vector<Statement*> fresh;
  for (const RevisedStatement& entry : entries_)
    if (entry.fresh && !entry.fresh->is_comment()) fresh.push_back(entry.fresh.get());
  if (fresh.empty()) return true;
  Evaluator& evaluator = core_.evaluator;
  run_on_deep_stack([&](const char* stack_limit) {
    evaluator.begin_input(core_.slots, stack_limit);
    for (Statement* statement : fresh) {
      statement->made = evaluator.run_statement(*statement->unit, statement->nodes, statement->may_print);
      statement->stamp = ++core_.last_stamp;
      ++core_.counters.statements_evaluated;
      core_.counters.objects_evaluated += statement->made.objects.size();
      if (core_.report.has_errors()) return;
    }
    evaluator.try_session_functions();
  });
  for (Statement* statement : fresh) {
    for (const scene::Object& object : statement->made.objects) {
      const Box3 box = object.is_visible ? scene::bounds(evaluator.scene(), object) : Box3{};
      if (box.is_finite()) statement->finite_box.extend(box);
    }
  }
  return !core_.report.has_errors();
}

// Expressions that are not things were only evaluated to be printed; they do not join the document.
void SessionChange::take_out_printed() {
  std::erase_if(entries_, [this](const RevisedStatement& entry) {
    if (!entry.fresh || !entry.fresh->made.printed) return false;
    const Value& value = *entry.fresh->made.printed;
    if (value.is_poison() || entry.fresh->made.is_print) return true;
    values.push_back({readable(value, core_.program), as_color(value)});
    if (value.is(ValueKind::number)) values.back().color.reset();
    return true;
  });
}

// A scene has one camera and one sky: a new one replaces one on a line of its own.
void SessionChange::settle_only(Trait which) {
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if ((entries_[i].traits() & which) != 0 && (!last || entries_[i].fresh)) last = i;
  if (!last) return;
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (i != *last && (entries_[i].traits() & which) != 0) others.push_back(i);
  const StatementResult& kept = entries_[*last].get().made;
  for (auto i = others.rbegin(); i != others.rend(); ++i) {
    const Statement& other = entries_[*i].get();
    const StatementResult& made = other.made;
    const bool has_more = which == trait_camera ? !other.may_print && !made.objects.empty()
                                                : !made.objects.empty() || made.lights.size() > 1;
    if (entries_[*i].fresh || has_more || other.declares() || !other.names.empty()) {
      core_.report.add(which == trait_camera ? errors::second_camera(kept.camera_place, made.camera_place)
                                             : errors::second_sky(*kept.sky_place, *made.sky_place));
      return;
    }
    changes.push_back((which == trait_camera ? "the camera replaced: " : "the sky replaced: ") + shortened(other.text));
    entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(*i));
  }
}

void SessionChange::check_scene_properties() {
  scene::Scene probe;
  const NodeType& type = core_.program.types.scene();
  std::vector<const PropertyValue*> written(type.properties.size());
  for (const RevisedStatement& entry : entries_) {
    if ((entry.traits() & trait_properties) == 0) continue;
    for (const PropertyValue& p : entry.get().made.properties) {
      if (p.value.is_poison()) continue;
      const Property& property = type.properties[p.id];
      if (const PropertyValue* first = written[p.id]) {
        core_.report.add(errors::property_set_twice(p.span, property.name, first->span));
        return;
      }
      written[p.id] = &p;
      property.field->set(&probe, core_.evaluator.scene_value(p));
    }
  }
  const auto problem = scene::check(probe);
  if (!problem) return;
  for (const PropertyValue* p : written) {
    if (!p || type.properties[p->id].name != problem->field) continue;
    core_.report.add(errors::properties_disagree(p->span, problem->message, {}, problem->advice));
  }
}

} // namespace rt::lang
