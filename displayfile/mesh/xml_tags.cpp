#include "displayfile/mesh/xml_tags.h"

#include <algorithm>

namespace displayfile {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kEndsName = " \t\r\n=/>\"'<";

}  // namespace

std::string_view XmlTag::local_name() const {
  const std::size_t colon = name.find(':');
  return colon == name.npos ? name : name.substr(colon + 1);
}

std::optional<std::string_view> XmlTag::value(std::string_view name_of_attribute) const {
  for (const auto& [attribute, text] : attributes) {
    if (attribute == name_of_attribute) return text;
  }
  return std::nullopt;
}

const XmlTag* XmlTags::next() {
  for (;;) {
    rest_.remove_prefix(std::min(rest_.find('<'), rest_.size()));
    if (rest_.empty()) return nullptr;
    if (pass_over_what_is_no_tag()) continue;
    rest_.remove_prefix(1);
    tag_.name = take_name();
    tag_.attributes.clear();
    if (tag_.name.empty()) continue;
    while (read_attribute()) {
    }
    if (!rest_.starts_with("/>")) ++open_;
    return &tag_;
  }
}

bool XmlTags::pass_over_what_is_no_tag() {
  constexpr std::pair<std::string_view, std::string_view> kOthers[] = {
      {"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}, {"</", ">"}};
  for (const auto& [begin, end] : kOthers) {
    if (!rest_.starts_with(begin)) continue;
    rest_.remove_prefix(begin.size());
    if (begin == "</") --open_;
    pass_over_past(end);
    return true;
  }
  return false;
}

void XmlTags::pass_over_past(std::string_view end) {
  const std::size_t at = rest_.find(end);
  rest_.remove_prefix(at == rest_.npos ? rest_.size() : at + end.size());
}

void XmlTags::pass_over_blanks() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
}

std::string_view XmlTags::take_name() {
  const std::string_view name = rest_.substr(0, rest_.find_first_of(kEndsName));
  rest_.remove_prefix(name.size());
  return name;
}

/// Reads name = "value". False at the end of the tag, or if there is no attribute.
bool XmlTags::read_attribute() {
  pass_over_blanks();
  const std::string_view name = take_name();
  pass_over_blanks();
  if (name.empty() || !rest_.starts_with('=')) return false;
  rest_.remove_prefix(1);
  pass_over_blanks();
  if (rest_.empty() || (rest_.front() != '"' && rest_.front() != '\'')) return false;
  const char quote = rest_.front();
  rest_.remove_prefix(1);
  const std::string_view value = rest_.substr(0, rest_.find(quote));
  rest_.remove_prefix(std::min(value.size() + 1, rest_.size()));
  tag_.attributes.emplace_back(name, value);
  return true;
}

}  // namespace displayfile
