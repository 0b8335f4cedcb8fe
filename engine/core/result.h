// Result: the environment may fail (a file, a device, a library), and the caller decides what then.
#pragma once
#include <string>
#include <tl/expected.hpp>

namespace pinfield {

/// What the environment refused, in a sentence for the user that names the file or device.
struct Failure {
    std::string message;
};

template <class T>
using Result = tl::expected<T, Failure>;

inline tl::unexpected<Failure> failure(std::string message) { return tl::unexpected<Failure>(Failure{std::move(message)}); }

}  // namespace pinfield
