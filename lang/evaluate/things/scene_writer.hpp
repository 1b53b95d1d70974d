#pragma once

#include "lang/evaluate/evaluation.hpp"
#include "lang/evaluate/things/target.hpp"

#include <optional>
#include <vector>

namespace rt::lang {

/// Puts things into the scene's description.
class SceneWriter : private EvaluationPart {
public:
  explicit SceneWriter(Evaluation& evaluation)
      : EvaluationPart(evaluation), builder_(evaluation.builder), scene_(evaluation.builder.scene),
        description_(evaluation.program.sources, evaluation.builder) {}

  /// Whether the target accepts the thing at all, so that a composite's `inside` is needed.
  bool takes(const ThingView& described, const Target& target) const;
  void put(const ThingView& described, Target& target);
  /// The shape of a thing that is about to be copied: its copies will share it.
  std::optional<scene::ShapeRef> shared_shape(const Thing& thing);
  /// Reports combinations among the objects whose parts refract differently.
  void check_media(const std::vector<scene::Object>& objects);

  scene::NameId default_name(Symbol symbol);
  scene::FieldValue scene_value(const PropertyValue& property);
  /// Where a camera was written, if one was.
  const std::optional<Span>& camera_place() const { return camera_place_; }
  /// The same for the sky.
  const std::optional<Span>& sky_place() const { return sky_place_; }
  void forget_camera_and_sky() {
    camera_place_.reset();
    sky_place_.reset();
  }

private:
  void put_shape(const ThingView& described, Target& target);
  void add_object(const ThingView& described, const ObjectAttributes& attributes, scene::TransformId transform,
                  Target& target);
  bool is_something(const ThingView& described);
  void put_light(const ThingView& described, Target& target);
  void put_camera(const ThingView& described, Target& target);
  void note_sky(const scene::Light& light, Span place, const Target& target);
  void put_lights_of(const Content& inside, const ObjectAttributes& attributes, const ThingView& described,
                     Target& target);
  std::optional<scene::ShapeRef> shape(const ThingView& described);
  std::optional<scene::ShapeRef> content_shape(Content& content, const NodeType& type, Span place);
  void set_fields(Prototype& made, const NodeType& type, std::span<const PropertyValue> properties);
  std::optional<Prototype> make(const ThingView& described);
  ObjectAttributes attributes_of(const ThingView& described);
  bool is_operand(const ThingView& described, scene::ShapeRef made);
  void remark_medium(const ThingView& described, scene::ShapeRef made);
  void fail_flattened(Span place);

  scene::Builder& builder_;
  scene::Scene& scene_;
  DescriptionWriter description_;
  std::optional<Span> camera_place_, sky_place_;
  std::vector<Span> combination_places_;     // by index of the combination
  std::vector<scene::NameId> default_names_; // by symbol: once needed
};

} // namespace rt::lang
