#pragma once

#include <gtest/gtest.h>

#include <string>

#include "clip/base/error.h"

namespace displayfile::test {

/// The message of the Error that a call throws; nothing if it throws none.
template <class Call>
std::string error_of(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// The call throws Error, whose message holds the words.
template <class Call>
void expect_error(Call&& call, const std::string& words) {
  try {
    call();
    ADD_FAILURE() << "expected an error: " << words;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos)
        << error.what() << "\ndoes not say: " << words;
  }
}

}  // namespace displayfile::test
