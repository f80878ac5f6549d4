#include "displayfile/output.h"

#include <array>
#include <sstream>
#include <string>

#include "clip/error.h"
#include "displayfile/output_file.h"

namespace displayfile {

namespace {

/// Kept in memory until commit().
class StreamOutput : public Output {
 public:
  explicit StreamOutput(const Destination& to) : name_(to.name()), to_(*to.stream()) {}

  const std::string& name() const override { return name_; }
  std::ostream& stream() override { return text_; }
  void finish() override {}
  void commit() override {
    std::array<char, 65536> block;
    while (text_.read(block.data(), block.size()), text_.gcount() > 0) {
      to_.write(block.data(), text_.gcount());
    }
    if (!to_.flush()) throw Error(name_ + ": not all could be written");
  }

 private:
  std::string name_;
  std::ostream& to_;
  std::stringstream text_;
};

}  // namespace

std::unique_ptr<Output> output_to(const Destination& to) {
  if (to.is_file()) return std::make_unique<OutputFile>(to.name());
  return std::make_unique<StreamOutput>(to);
}

}  // namespace displayfile
