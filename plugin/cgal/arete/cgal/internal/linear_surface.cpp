// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/cgal/internal/surface.h"

namespace arete::cgal::detail {
namespace {

class LinearSurface final : public ScatteredSurface {
 public:
  double inside(const Point& place, Face face) const override {
    const Point& a = face->vertex(0)->point();
    const Vector ab = face->vertex(1)->point() - a;
    const Vector ac = face->vertex(2)->point() - a;
    const Vector ap = place - a;
    const double area = CGAL::determinant(ab, ac);
    const double v = CGAL::determinant(ap, ac) / area;
    const double w = CGAL::determinant(ab, ap) / area;
    const double z = face->vertex(0)->info().z;
    return z + v * (face->vertex(1)->info().z - z) + w * (face->vertex(2)->info().z - z);
  }

  double on_hull(const HullFoot& foot) const override {
    return (1 - foot.t) * foot.a->info().z + foot.t * foot.b->info().z;
  }
};

}  // namespace

std::unique_ptr<ScatteredSurface> linear_surface() { return std::make_unique<LinearSurface>(); }

}  // namespace arete::cgal::detail
