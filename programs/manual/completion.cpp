#include "programs/manual/completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

namespace displayfile {

namespace {

struct Candidate {
  std::string word, what;
};

/// The beginning of a description, up to the first of `:;[`.
std::string brief(std::string_view description) {
  return std::string(description.substr(0, description.find_first_of(":;[")));
}

const CLI::App* subcommand_named(const CLI::App& app, std::string_view name) {
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == name) return command;
  }
  return nullptr;
}

/// The option that a word names, with a value after = or without; null if none.
const CLI::Option* option_of(const CLI::App& command, std::string_view word) {
  const std::string name(word.substr(0, word.find('=')));
  for (const CLI::Option* option : command.get_options()) {
    if (option->nonpositional() && option->check_name(name)) return option;
  }
  return nullptr;
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }
bool takes_several(const CLI::Option& option) { return option.get_items_expected_max() > 1; }

/// The words before the last one, as the parser takes them.
class TypedWords {
 public:
  TypedWords(const CLI::App& command, std::span<const std::string> words) : command_(command) {
    for (const std::string& word : words) take(word);
  }

  /// Whose value comes next; null if none's.
  const CLI::Option* open() const { return open_; }
  /// True if the value may be left out: another has been given.
  bool may_close() const { return open_ == nullptr || has_value_; }
  bool options_are_over() const { return options_are_over_; }
  bool has(const CLI::Option* option) const { return given_.contains(option); }

  /// The positional option that a word would set; null if there is none.
  const CLI::Option* positional() const {
    int before = positionals_;
    for (const CLI::Option* option : command_.get_options()) {
      if (!option->get_positional()) continue;
      if (before < option->get_items_expected_max()) return option;
      before -= option->get_items_expected_max();
    }
    return nullptr;
  }

 private:
  void take(const std::string& word) {
    const bool is_name = !options_are_over_ && word.size() > 1 && word[0] == '-';
    if (open_ != nullptr && (!has_value_ || !is_name)) {
      has_value_ = true;
      if (!takes_several(*open_)) open_ = nullptr;
    } else if (is_name) {
      options_are_over_ = word == "--";
      open_ = nullptr;
      const CLI::Option* const option = option_of(command_, word);
      if (option == nullptr) return;
      given_.insert(option);
      has_value_ = word.find('=') != word.npos;
      if (takes_value(*option) && (!has_value_ || takes_several(*option))) open_ = option;
    } else {
      ++positionals_;
    }
  }

  const CLI::App& command_;
  const CLI::Option* open_ = nullptr;
  bool has_value_ = false, options_are_over_ = false;
  int positionals_ = 0;
  std::set<const CLI::Option*> given_;
};

class Completions {
 public:
  Completions(std::string typed, std::ostream& out) : typed_(std::move(typed)), out_(out) {}

  void offer(const Candidate& candidate) {
    if (!candidate.word.starts_with(typed_)) return;
    out_ << candidate.word;
    if (!candidate.what.empty()) out_ << '\t' << candidate.what;
    out_ << '\n';
    goes_on_ = goes_on_ || candidate.word.ends_with('=');
  }

  void offer_names(const CLI::App& command, const TypedWords* typed) {
    for (const CLI::Option* option : command.get_options()) {
      if (!option->nonpositional() || option->get_group().empty()) continue;
      if (typed != nullptr && typed->has(option) && !takes_several(*option)) continue;
      for (const std::string& name : option->get_lnames()) {
        offer({"--" + name, brief(option->get_description())});
      }
    }
  }

  /// The value of an option; in the typed word it begins after the first `skipped` characters.
  void offer_values(const CLI::Option& option, std::size_t skipped,
                    std::span<const NamedValues> named) {
    const OfferedValues values = offered_values(value_name(option).name, named);
    std::string before = typed_.substr(0, skipped);
    std::set<std::string> named_already;
    if (values.several) {
      for (auto comma = typed_.find(',', skipped); comma != typed_.npos;
           comma = typed_.find(',', skipped)) {
        named_already.insert(typed_.substr(skipped, comma - skipped));
        skipped = comma + 1;
      }
      before = typed_.substr(0, skipped);
    }
    for (const std::string& word : values.words) {
      if (!named_already.contains(word)) offer({before + word, ""});
    }
    if (values.files) out_ << fmt::format(":files {}", fmt::join(values.extensions, " ")) << '\n';
    if (values.folders) out_ << ":folders\n";
    goes_on_ = goes_on_ || values.several;
  }

  ~Completions() {
    if (goes_on_) out_ << ":more\n";
  }

 private:
  const std::string typed_;
  std::ostream& out_;
  bool goes_on_ = false;
};

}  // namespace

void print_completions(const CLI::App& app, std::span<const std::string> words,
                       std::span<const NamedValues> named, std::ostream& out) {
  if (words.empty()) return;
  const std::string& last = words.back();
  Completions completions(last, out);
  const bool is_helped = words.size() == 2 && words.front() == "help";
  if (words.size() == 1 || is_helped) {
    for (const CLI::App* command : app.get_subcommands({})) {
      completions.offer({command->get_name(), brief(command->get_description())});
    }
    if (is_helped) return;
    if (last.starts_with('-')) completions.offer_names(app, nullptr);
    return;
  }
  const CLI::App* const command = subcommand_named(app, words.front());
  if (command == nullptr) return;
  const TypedWords typed(*command, words.subspan(1, words.size() - 2));
  const std::size_t equals = last.find('=');
  const bool is_name = last.starts_with('-') && !typed.options_are_over();
  if (typed.open() != nullptr && !(is_name && typed.may_close())) {
    completions.offer_values(*typed.open(), 0, named);
  } else if (is_name && equals != last.npos) {
    const CLI::Option* const option = option_of(*command, last);
    if (option != nullptr) completions.offer_values(*option, equals + 1, named);
  } else if (is_name) {
    completions.offer_names(*command, &typed);
  } else if (const CLI::Option* const positional = typed.positional()) {
    completions.offer_values(*positional, 0, named);
  }
}

}  // namespace displayfile
