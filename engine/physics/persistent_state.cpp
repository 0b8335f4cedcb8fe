#include "engine/physics/persistent_state.h"

#include "engine/core/hash.h"

namespace pinfield {

std::uint64_t hash_of(const PersistentState& state) {
    Hash64 hash;
    each_value(state, [&](const auto& value) {
        using T = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_enum_v<T>) hash.feed(static_cast<std::int64_t>(value));
        else if constexpr (std::is_arithmetic_v<T>) hash.feed(value);
        else if constexpr (requires { value.has_value(); }) hash.feed(value.has_value());
        else hash.feed(value.size());
    });
    return hash.value();
}

}  // namespace pinfield
