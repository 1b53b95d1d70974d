#pragma once

#include "renderer/compile/geometries.hpp"
#include "tools/explain/derivation/derivation.hpp"

#include <optional>

/// What the derivations of the shapes share. Each shape has an overload of `derive_shape`.
namespace rt::tools::explain {

/// Records a derivation.
class Steps {
public:
  Steps(Derivation& derivation, const Hit& found, bool is_operand)
      : derivation_(derivation), found_(found), is_operand_(is_operand) {}

  const Ray& ray() const { return derivation_.ray; }
  const Hit& found() const { return found_; }

  void equation(std::string text) { derivation_.equation = std::move(text); }
  /// Adds a quantity to the current line.
  Steps& put(std::string_view key, std::string_view label, double value);
  Steps& put(std::string_view key, std::string_view label, const Vec3& value);
  /// Ends the line with a conclusion, which may be empty.
  void so(std::string words = {});

  /// A place where the ray might hit the shape.
  struct Candidate {
    double t;
    std::string name; ///< "t₁" or "the top end"
    bool counts;      ///< it satisfies the shape's own tests
  };
  /// States which of them the tracer took and why it rejected the others; ends the derivation.
  void choose(std::vector<Candidate> candidates);

  /// The roots of a·t² + b·t + c = 0 from their coefficients: the discriminant, and the roots if there are any. A
  /// discriminant that is negative only by rounding counts as 0: the tracer has found that the ray touches.
  struct Roots {
    int count = 0;
    double first = 0, second = 0;
  };
  Roots solve(double a, double b, double c, std::string_view surface);

private:
  Derivation& derivation_;
  const Hit& found_;
  bool is_operand_; // of a combination
  DerivationLine line_;
};

void derive_shape(Steps& steps, const SphereGeometry& sphere);
void derive_shape(Steps& steps, const PlaneGeometry& plane);
void derive_shape(Steps& steps, const CylinderGeometry& cylinder);
void derive_shape(Steps& steps, const ConeGeometry& cone);
void derive_shape(Steps& steps, const BoxGeometry& box);
void derive_shape(Steps& steps, const DiscGeometry& disc);
void derive_shape(Steps& steps, const TriangleGeometry& triangle);
void derive_shape(Steps& steps, const QuadGeometry& quad);
void derive_shape(Steps& steps, const PolygonGeometry& polygon);

} // namespace rt::tools::explain
