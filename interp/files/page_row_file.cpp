#include "interp/files/page_row_file.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace displayfile {

namespace {

class PageRowFile : public RowFile {
 public:
  PageRowFile(std::unique_ptr<RowFile> file, const PixelPage& page, std::uint32_t blank)
      : file_(std::move(file)), page_(page), blank_(blank) {
    row_.width = page.width;
    row_.height = 1;
  }
  void write(const Picture& rows) override {
    while (written_ < page_.top) write_blank();
    const auto width = static_cast<std::size_t>(rows.width);
    for (int y = 0; y < rows.height; ++y) {
      row_.pixels.assign(static_cast<std::size_t>(page_.width), blank_);
      std::ranges::copy(std::span(rows.pixels).subspan(static_cast<std::size_t>(y) * width, width),
                        row_.pixels.begin() + page_.left);
      write_row();
    }
  }
  void finish() override {
    while (written_ < page_.height) write_blank();
    file_->finish();
  }
  void commit() override { file_->commit(); }

 private:
  void write_blank() {
    row_.pixels.assign(static_cast<std::size_t>(page_.width), blank_);
    write_row();
  }
  void write_row() {
    file_->write(row_);
    ++written_;
  }

  std::unique_ptr<RowFile> file_;
  PixelPage page_;
  std::uint32_t blank_;
  Picture row_;
  int written_ = 0;
};

}  // namespace

std::unique_ptr<RowFile> page_row_file(std::unique_ptr<RowFile> file, const PixelPage& page,
                                       std::uint32_t blank) {
  return std::make_unique<PageRowFile>(std::move(file), page, blank);
}

}  // namespace displayfile
