#include "tests/bench/command/contenders.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "displayfile/segments/hidden_surface_check.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/plain_z_buffer.h"
#include "tests/bench/command/peers.h"

namespace displayfile::bench {

namespace {

RasterRequest request_of(const Frame& frame, HiddenMethod method) {
  RasterRequest request;
  request.width = frame.width;
  request.height = frame.height;
  request.surfaces.threads = frame.threads;
  request.surfaces.method = method;
  return request;
}

RasterRequest with_ids_and_depth(RasterRequest request) {
  request.ids = request.depth = true;
  return request;
}

/// Painted in order, or by an image-space method.
class SoftwareDrawing : public Drawing {
 public:
  SoftwareDrawing(const DisplayFile& file, const RasterRequest& request)
      : file_(file), request_(request) {}
  void draw_anew() override {
    renderer_.emplace();
    renderer_->draw(file_, request_);
  }
  void draw_again() override { renderer_->draw(file_, request_); }
  Picture judged() override { return renderer_->draw(file_, with_ids_and_depth(request_)); }

 private:
  const DisplayFile& file_;
  RasterRequest request_;
  std::optional<SoftwareRenderer> renderer_;
};

/// All segments together, sorted and painted back to front, or divided into the visible pieces,
/// which are painted. The pieces are kept.
class SortedDrawing : public Drawing {
 public:
  SortedDrawing(const DisplayFile& file, const RasterRequest& request, HiddenMethod method,
                const Precision& precision)
      : file_(file), request_(request), method_(method) {
    options_.precision = precision;
    options_.threads = request.surfaces.threads;
    request_.sorted = precision.exact;
  }
  void draw_anew() override {
    renderer_.emplace();
    sorted_ = file_;
    sorted_.set_sorted(hidden_surface_check(file_.visible_segments(), options_.by(method_)));
    renderer_->draw(sorted_, request_);
  }
  void draw_again() override { renderer_->draw(sorted_, request_); }
  Picture judged() override { return renderer_->draw(sorted_, with_ids_and_depth(request_)); }
  std::optional<Pieces> pieces() const override {
    return Pieces{file_.polygons(), sorted_.sorted()->counts.pieces};
  }

 private:
  const DisplayFile& file_;
  RasterRequest request_;
  HiddenMethod method_;
  SurfacePlan options_;
  DisplayFile sorted_;
  std::optional<SoftwareRenderer> renderer_;
};

class PlainDrawing : public Drawing {
 public:
  PlainDrawing(const DisplayFile& file, const RasterRequest& request, DepthFormat format)
      : file_(file), request_(request), format_(format) {}
  void draw_anew() override { picture_ = draw_with_plain_z_buffer(file_, request_, format_); }
  Picture judged() override {
    return draw_with_plain_z_buffer(file_, with_ids_and_depth(request_), format_);
  }

 private:
  const DisplayFile& file_;
  RasterRequest request_;
  DepthFormat format_;
  Picture picture_;
};

Contender painter() {
  return {std::string(name_of(HiddenMethod::none)),
          "",
          false,
          true,
          true,
          [](const DisplayFile& file, const Frame& frame) {
            return std::make_unique<SoftwareDrawing>(file, request_of(frame, HiddenMethod::none));
          }};
}

Contender image_space(HiddenMethod method, const Precision& precision) {
  return {std::string(name_of(method)),
          name_of_precision(precision),
          precision.exact,
          true,
          true,
          [=](const DisplayFile& file, const Frame& frame) {
            RasterRequest request = request_of(frame, method);
            request.surfaces.precision = precision;
            return std::make_unique<SoftwareDrawing>(file, request);
          }};
}

Contender object_space(HiddenMethod method, const Precision& precision) {
  return {std::string(name_of(method)),
          name_of_precision(precision),
          precision.exact,
          true,
          true,
          [=](const DisplayFile& file, const Frame& frame) {
            return std::make_unique<SortedDrawing>(file, request_of(frame, HiddenMethod::none),
                                                   method, precision);
          }};
}

Contender plain(const DepthFormatEntry& entry) {
  return {"plain-z-buffer",
          std::string(entry.name),
          false,
          false,
          true,
          [format = entry.format](const DisplayFile& file, const Frame& frame) {
            return std::make_unique<PlainDrawing>(file, request_of(frame, HiddenMethod::z_buffer),
                                                  format);
          }};
}

}  // namespace

bool is_in_object_space(std::string_view method) {
  return std::ranges::any_of(kObjectSpaceMethods,
                             [&](HiddenMethod known) { return name_of(known) == method; });
}

std::string name_of_precision(const Precision& precision) {
  if (precision.exact) return "exact";
  std::string eps = fmt::format("{:g}", precision.roundoff);
  if (const auto zero = eps.find("e-0"); zero != eps.npos) eps.erase(zero + 2, 1);
  return "roundoff=" + eps;
}

std::vector<Contender> contenders(std::span<const double> roundoffs) {
  std::vector<Precision> precisions{{}};
  for (const double roundoff : roundoffs) precisions.push_back({false, roundoff});
  std::vector<Contender> all{painter(), image_space(HiddenMethod::automatic, {})};
  for (const ImageSpaceEntry& entry : image_space_methods()) {
    for (const Precision& p : precisions) all.push_back(image_space(entry.method, p));
  }
  for (const HiddenMethod method : kObjectSpaceMethods) {
    for (const Precision& p : precisions) {
      if (p.exact || method != HiddenMethod::map) all.push_back(object_space(method, p));
    }
  }
  for (const DepthFormatEntry& entry : depth_formats()) all.push_back(plain(entry));
  for (Contender& peer : peers()) all.push_back(std::move(peer));
  return all;
}

Contender reference_contender() { return image_space(HiddenMethod::z_buffer, {}); }

}  // namespace displayfile::bench
