#include "displayfile/text/output.h"

#include <filesystem>
#include <string>
#include <utility>

#include "clip/base/collected_text.h"
#include "clip/base/error.h"
#include "displayfile/text/output_file.h"

namespace displayfile {

namespace {

/// Keeps output in memory until commit().
class StreamOutput : public Output {
 public:
  explicit StreamOutput(const Destination& to) : name_(to.name()), to_(*to.stream()) {}

  const std::string& name() const override { return name_; }
  std::ostream& stream() override { return text_; }
  void finish() override { text_.require_whole(); }
  void commit() override {
    const std::string text = std::move(text_).str();
    to_.write(text.data(), static_cast<std::streamsize>(text.size()));
    if (!to_.flush()) throw Error(name_ + ": not all could be written");
  }

 private:
  std::string name_;
  std::ostream& to_;
  CollectedText text_;
};

}  // namespace

std::string Destination::extension() const {
  return is_file() ? std::filesystem::path(path_).extension().string() : std::string();
}

std::unique_ptr<Output> output_to(const Destination& to) {
  if (to.is_file()) return std::make_unique<OutputFile>(to.name());
  return std::make_unique<StreamOutput>(to);
}

}  // namespace displayfile
