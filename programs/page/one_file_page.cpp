#include "programs/page/one_file_page.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "clip/base/error.h"

namespace displayfile {

namespace {

constexpr std::string_view kBeforeData = R"(<script type="application/json" id="data">)";
constexpr std::string_view kStill = "<!-- still -->";

/// The part of a line between two texts, if these are its beginning and end.
std::optional<std::string_view> between(std::string_view line, std::string_view before,
                                        std::string_view after) {
  line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  if (!line.starts_with(before) || !line.ends_with(after)) return std::nullopt;
  if (line.size() < before.size() + after.size()) return std::nullopt;
  return line.substr(before.size(), line.size() - before.size() - after.size());
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      result += c;
    }
  }
  return result;
}

/// JSON has this character in strings alone, where it may be written so; a browser would look for
/// the script's end in it.
std::string json_in_page(std::string_view json) {
  std::string result;
  result.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      result += "\\u003c";
    } else {
      result += c;
    }
  }
  return result;
}

std::string_view without_declaration(std::string_view svg) {
  const std::size_t begin = svg.find("<svg");
  return begin == std::string_view::npos ? svg : svg.substr(begin);
}

class Writer {
 public:
  Writer(const PageFiles& files, const PageContents& contents)
      : files_(files), contents_(contents) {}

  void write(std::string_view line) {
    if (const auto style = between(line, R"(<link rel="stylesheet" href=")", R"(">)")) {
      enclose("<style>\n", *style, "</style>");
    } else if (const auto script = between(line, R"(<script src=")", R"("></script>)")) {
      enclose("<script>\n", *script, "</script>");
    } else if (const auto data = between(line, kBeforeData, "</script>")) {
      page_ += fmt::format("{}{}</script>", kBeforeData, json_in_page(contents_.data));
      has_data_ = true;
    } else if (const auto title = between(line, "<title>", "</title>");
               title && !contents_.title.empty()) {
      page_ += fmt::format("<title>{}</title>", escaped(contents_.title));
    } else if (line.ends_with(kStill)) {
      page_ += without_declaration(contents_.still);
      has_still_ = true;
    } else {
      page_ += line;
    }
    page_ += '\n';
  }

  std::string finish(const std::string& name) {
    if (!has_data_) throw Error(fmt::format("{} has no line '{}{{}}</script>'", name, kBeforeData));
    if (!contents_.still.empty() && !has_still_) {
      throw Error(fmt::format("{} has no line '{}'", name, kStill));
    }
    return std::move(page_);
  }

 private:
  void enclose(std::string_view before, std::string_view name, std::string_view end) {
    const std::string text = files_.text(std::string(name));
    if (text.find(end) != std::string::npos) {
      throw Error(fmt::format("{} cannot be part of a page: '{}' stands in it", name, end));
    }
    page_ += before;
    page_ += text;
    page_ += end;
  }

  const PageFiles& files_;
  const PageContents& contents_;
  std::string page_;
  bool has_data_ = false, has_still_ = false;
};

}  // namespace

std::string one_file_page(const PageFiles& files, const std::string& page,
                          const PageContents& contents) {
  const std::string text = files.text(page);
  Writer writer(files, contents);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    writer.write(std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
  }
  return writer.finish(page);
}

}  // namespace displayfile
