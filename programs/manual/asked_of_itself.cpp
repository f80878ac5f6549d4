#include "programs/manual/asked_of_itself.h"

#include <iostream>
#include <string>
#include <vector>

#include "programs/manual/completion.h"
#include "programs/manual/manual_page.h"

namespace displayfile {

AskedOfItself::AskedOfItself(int argc, char** argv)
    : words_(argv + 1, static_cast<std::size_t>(argc > 0 ? argc - 1 : 0)) {
  if (words_.empty()) return;
  const std::string_view first = words_.front();
  completion_ = first == kComplete;
  manual_ = first == kManual;
  if (anything()) words_ = words_.subspan(1);
}

std::string_view AskedOfItself::subcommand() const {
  return words_.empty() ? std::string_view() : words_.front();
}

bool AskedOfItself::of_subcommand(const CLI::App& named) const {
  return subcommand() == named.get_name() && (manual_ || words_.size() > 1);
}

void AskedOfItself::tell(const CLI::App& app, std::span<const NamedValues> named) const {
  const std::vector<std::string> words(words_.begin(), words_.end());
  if (completion_) return print_completions(app, words, named, std::cout);
  if (words.empty()) return print_manual_page(app, app, std::cout);
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == words.front()) print_manual_page(app, *command, std::cout);
  }
}

}  // namespace displayfile
