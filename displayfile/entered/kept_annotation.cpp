#include "displayfile/entered/kept_annotation.h"

#include "clip/base/words.h"
#include "clip/surfaces.h"

namespace displayfile {

namespace {

using Kind = KeptAnnotation::Kind;
constexpr Word<Kind> kKinds[] = {
    {Kind::leader, "leader"},     {Kind::balloon, "balloon"}, {Kind::linear, "linear"},
    {Kind::diameter, "diameter"}, {Kind::radius, "radius"},   {Kind::angle, "angle"},
    {Kind::title, "title"},       {Kind::list, "list"},
};

}  // namespace

std::string_view name_of(KeptAnnotation::Kind kind) { return word_of(kKinds, kind); }

std::optional<KeptAnnotation> viewed(const KeptAnnotation& annotation, const ViewVolume& volume) {
  KeptAnnotation result = annotation;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    Point3& point = result.points[i];
    const HomogeneousPoint p = volume.transform(point);
    if (i < result.anchors() && volume.outcode(p) != 0) return std::nullopt;
    if (!(p.w > 0.0)) return std::nullopt;
    point = volume.to_device(p);
    if (!in_range(point)) return std::nullopt;
  }
  return result;
}

KeptAnnotation transformed(KeptAnnotation annotation, const ImageTransformation& image) {
  if (image.is_identity()) return annotation;
  const ImageMatrix matrix(image);
  for (Point3& p : annotation.points) p = matrix.apply(p);
  return annotation;
}

}  // namespace displayfile
