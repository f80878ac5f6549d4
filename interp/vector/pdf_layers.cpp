#include "interp/vector/pdf_layers.h"

#include <fmt/format.h>

#include <cstdlib>
#include <memory>
#include <unordered_map>
#include <vector>

#include "clip/base/error.h"
#include "interp/device/qpdf.h"

namespace displayfile {

namespace {

/// A document being changed.
class Document {
 public:
  explicit Document(const std::string& bytes) : data_(qpdf().init()) {
    qpdf().silence_errors(data_);
    qpdf().read_memory(data_, "picture", bytes.data(), bytes.size(), nullptr);
    check();
    page_ = qpdf().get_page_n(data_, 0);
    check();
  }
  ~Document() { qpdf().cleanup(&data_); }
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  std::string content() {
    unsigned char* bytes = nullptr;
    std::size_t size = 0;
    qpdf().oh_get_page_content_data(data_, page_, &bytes, &size);
    const std::unique_ptr<unsigned char, decltype(&std::free)> owned(bytes, &std::free);
    check();
    return {reinterpret_cast<const char*>(bytes), size};
  }
  void replace_content(const std::string& content) {
    const qpdf_oh none = qpdf().oh_new_null(data_);
    const qpdf_oh stream = qpdf().oh_new_stream(data_);
    qpdf().oh_replace_stream_data(data_, stream,
                                  reinterpret_cast<const unsigned char*>(content.data()),
                                  content.size(), none, none);
    qpdf().oh_replace_key(data_, page_, "/Contents", stream);
    check();
  }

  /// Names the layers in the page's resources, L0, L1, ..., and in the list that readers show.
  void add_layers(std::span<const std::string_view> names) {
    const qpdf_oh properties = qpdf().oh_new_dictionary(data_);
    const qpdf_oh all = qpdf().oh_new_array(data_), order = qpdf().oh_new_array(data_);
    for (std::size_t k = 0; k < names.size(); ++k) {
      const qpdf_oh layer = qpdf().oh_new_dictionary(data_);
      set(layer, "/Type", qpdf().oh_new_name(data_, "/OCG"));
      set(layer, "/Name", qpdf().oh_new_unicode_string(data_, std::string(names[k]).c_str()));
      const qpdf_oh shared = qpdf().make_indirect_object(data_, layer);
      set(properties, fmt::format("/L{}", k).c_str(), shared);
      qpdf().oh_append_item(data_, all, shared);
      qpdf().oh_append_item(data_, order, shared);
    }
    set(qpdf().oh_get_key(data_, page_, "/Resources"), "/Properties", properties);
    const qpdf_oh shown = qpdf().oh_new_dictionary(data_), list = qpdf().oh_new_dictionary(data_);
    set(shown, "/Order", order);
    set(list, "/OCGs", all);
    set(list, "/D", shown);
    set(qpdf().get_root(data_), "/OCProperties", list);
    check();
  }

  /// Removes the structure tree that Cairo wrote for the marks, which become layers.
  void remove_structure() {
    qpdf().oh_remove_key(data_, qpdf().get_root(data_), "/StructTreeRoot");
    qpdf().oh_remove_key(data_, qpdf().get_root(data_), "/MarkInfo");
    qpdf().oh_remove_key(data_, page_, "/StructParents");
    check();
  }

  std::string bytes() {
    qpdf().init_write_memory(data_);
    qpdf().set_deterministic_ID(data_, QPDF_TRUE);
    qpdf().set_object_stream_mode(data_, qpdf_o_disable);
    qpdf().write(data_);
    check();
    return {reinterpret_cast<const char*>(qpdf().get_buffer(data_)),
            qpdf().get_buffer_length(data_)};
  }

 private:
  void set(qpdf_oh dictionary, const char* key, qpdf_oh value) {
    qpdf().oh_replace_key(data_, dictionary, key, value);
  }
  void check() {
    if (qpdf().has_error(data_) == QPDF_FALSE) return;
    throw Error(fmt::format("the PDF's layers cannot be written: {}",
                            qpdf().get_error_full_text(data_, qpdf().get_error(data_))));
  }

  qpdf_data data_;
  qpdf_oh page_ = 0;
};

/// Replaces the content's marks, `/Span << /MCID n >> BDC`, by those of layers, `/OC /Ln BDC`.
std::string with_marks_of_layers(std::string_view content, std::span<const std::size_t> layers) {
  const std::string mark = fmt::format("/{} <<", kMarkOfLayer);
  constexpr std::string_view kBegin = "BDC";
  std::string changed;
  changed.reserve(content.size());
  std::size_t marks = 0;
  for (;;) {
    const std::size_t at = content.find(mark);
    const std::size_t end = at == content.npos ? at : content.find(kBegin, at);
    changed += content.substr(0, at);
    if (end == content.npos) break;
    if (marks < layers.size()) changed += fmt::format("/OC /L{} {}", layers[marks], kBegin);
    ++marks;
    content.remove_prefix(end + kBegin.size());
  }
  if (marks == layers.size()) return changed;
  throw Error(fmt::format("the PDF's layers cannot be written: Cairo marked {} of {} parts", marks,
                          layers.size()));
}

}  // namespace

std::string with_layers(const std::string& document, std::span<const std::string> layer_of_parts) {
  std::vector<std::string_view> names;
  std::unordered_map<std::string_view, std::size_t> places;  // in the names
  std::vector<std::size_t> layers;
  for (const std::string_view name : layer_of_parts) {
    const auto [known, is_new] = places.try_emplace(name, names.size());
    if (is_new) names.push_back(name);
    layers.push_back(known->second);
  }
  Document changed(document);
  changed.replace_content(with_marks_of_layers(changed.content(), layers));
  changed.add_layers(names);
  changed.remove_structure();
  return changed.bytes();
}

bool has_pdf_layers() {
  try {
    qpdf();
    return true;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace displayfile
