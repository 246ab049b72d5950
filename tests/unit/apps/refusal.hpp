#pragma once
#include <string>

#include "apps/common/errors.hpp"

namespace seiche::test {

/// What a call that may refuse a folder says of it; nothing where it doesn't.
template <class F>
std::string refusal(F call) {
  try {
    call();
  } catch (const apps::BadFolder& error) {
    return error.what();
  }
  return "";
}

}  // namespace seiche::test
