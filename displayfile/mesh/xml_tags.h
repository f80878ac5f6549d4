#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace displayfile {

/// A start tag of an XML text, as written: names with prefixes, attribute values without entities
/// replaced.
struct XmlTag {
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string_view>> attributes;

  /// The name without its prefix.
  std::string_view local_name() const;
  /// The value of the attribute with this full name; nothing if there is none.
  std::optional<std::string_view> value(std::string_view name_of_attribute) const;
};

/// The start tags of an XML text in UTF-8, in order. Comments, CDATA sections, processing
/// instructions, declarations and end tags are skipped. It does not validate: text that is not
/// well-formed gives fewer or wrong tags.
class XmlTags {
 public:
  /// The text must outlive the tags.
  explicit XmlTags(std::string_view text) : rest_(text) {}

  /// The next tag, valid until the next call; null at the end.
  const XmlTag* next();
  /// True if as many elements were ended so far as were begun.
  bool all_closed() const { return open_ == 0; }

 private:
  bool pass_over_what_is_no_tag();
  void pass_over_past(std::string_view end);
  void pass_over_blanks();
  std::string_view take_name();
  bool read_attribute();

  std::string_view rest_;
  XmlTag tag_;
  std::ptrdiff_t open_ = 0;  // elements
};

}  // namespace displayfile
