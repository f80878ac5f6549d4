#include "programs/process/warnings.h"

#include <iostream>
#include <streambuf>
#include <utility>

namespace displayfile {

namespace {

thread_local std::ostream* collected = nullptr;

/// Replaces standard error's own buffer: a thread's output goes to its collector.
class ErrorsByThread : public std::streambuf {
 public:
  ErrorsByThread() : standard_error_(std::cerr.rdbuf(this)) {}
  ~ErrorsByThread() override { std::cerr.rdbuf(standard_error_); }

 protected:
  int_type overflow(int_type c) override {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    return target().sputc(traits_type::to_char_type(c));
  }
  std::streamsize xsputn(const char* text, std::streamsize count) override {
    return target().sputn(text, count);
  }
  int sync() override { return target().pubsync(); }

 private:
  std::streambuf& target() const {
    return collected == nullptr ? *standard_error_ : *collected->rdbuf();
  }

  std::streambuf* standard_error_;
};

}  // namespace

std::ostream& warnings() { return collected == nullptr ? std::cerr : *collected; }

CollectedWarnings::CollectedWarnings(std::ostream& into) {
  static const ErrorsByThread in_place;
  before_ = std::exchange(collected, &into);
}

CollectedWarnings::~CollectedWarnings() { collected = before_; }

NamedWarnings::NamedWarnings(std::string name) : name_(std::move(name)) {
  collected_.emplace(made_);
}

NamedWarnings::~NamedWarnings() {
  collected_.reset();
  for (std::string line; std::getline(made_, line);) {
    if (!line.empty()) warnings() << name_ << ": " << line << '\n';
  }
}

}  // namespace displayfile
