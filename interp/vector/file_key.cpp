#include "interp/vector/file_key.h"

#include <cstddef>
#include <cstdint>
#include <ostream>

namespace displayfile {

namespace {

/// Up to eight bytes as a number, the same on every machine.
std::uint64_t number_of(std::string_view bytes) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    number |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  }
  return number;
}

/// Each factor is odd, so that no bit of the previous hash is lost.
std::uint64_t mixed(std::uint64_t hash, std::uint64_t more) {
  hash = (hash ^ more) * 0xD6E8FEB86659FD93u;
  return hash ^ (hash >> 32);
}

}  // namespace

std::string file_key(std::initializer_list<std::string_view> parts) {
  constexpr std::size_t kWord = sizeof(std::uint64_t);
  std::uint64_t hash = parts.size();
  for (const std::string_view part : parts) {
    hash = mixed(hash, part.size());
    std::size_t at = 0;
    for (; at + kWord <= part.size(); at += kWord)
      hash = mixed(hash, number_of(part.substr(at, kWord)));
    hash = mixed(hash, number_of(part.substr(at)));
  }
  hash = mixed(mixed(hash, 0), 0);
  std::string key(7, '0');
  for (char& c : key) {
    c = "0123456789abcdefghijklmnopqrstuvwxyz"[hash % 36];
    hash /= 36;
  }
  return key;
}

void write_with_key(std::string_view text, std::string_view key, std::ostream& out) {
  constexpr char kEndOfOwn = kOwn.back();
  for (std::size_t mark = text.find(kEndOfOwn); mark != text.npos; mark = text.find(kEndOfOwn)) {
    out << text.substr(0, mark) << key;
    text.remove_prefix(mark + 1);
  }
  out << text;
}

void write_with_prefix(std::string_view text, std::string_view prefix, std::ostream& out) {
  const auto is_of_name = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  };
  for (std::size_t own = text.find(kOwn); own != text.npos; own = text.find(kOwn)) {
    std::size_t name = own;
    while (name > 0 && is_of_name(text[name - 1])) --name;
    out << text.substr(0, name) << prefix << text.substr(name, own - name);
    text.remove_prefix(own + kOwn.size());
  }
  out << text;
}

void write_with_own_names(std::initializer_list<std::string_view> parts, std::string_view prefix,
                          std::ostream& out) {
  const std::string key = prefix.empty() ? file_key(parts) : std::string();
  for (const std::string_view part : parts) {
    prefix.empty() ? write_with_key(part, key, out) : write_with_prefix(part, prefix, out);
  }
}

}  // namespace displayfile
