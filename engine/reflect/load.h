// Between a described struct and its packed block (see pack() in node_type.h). Over any scalar, so it may enter a SIMD unit:
// everything here is a template over the node, which carries its scalar in its name.
#pragma once
#include <tuple>
#include <type_traits>
#include <vector>

#include "engine/core/point.h"

namespace pinfield {

namespace detail {

template <class M>
inline constexpr bool is_point = false;
template <class R>
inline constexpr bool is_point<Point<R>> = true;
template <class M>
inline constexpr bool is_point_list = false;
template <class R>
inline constexpr bool is_point_list<PointList<R>> = true;
template <class M>
inline constexpr bool is_choice_list = false;
template <class E>
inline constexpr bool is_choice_list<ChoiceList<E>> = true;

template <class T, class M>
inline void load_member(M T::*member, T& node, const double* block, int& slot) {
    M& out = node.*member;
    if constexpr (is_point<M>) {
        using R = std::remove_cvref_t<decltype(out.x)>;
        out.x = R(block[slot]);
        out.y = R(block[slot + 1]);
        slot += 2;
    } else if constexpr (is_point_list<M>) {
        out.xy = block + static_cast<int>(block[slot]);
        out.count = static_cast<int>(block[slot + 1]);
        slot += 2;
    } else if constexpr (is_choice_list<M>) {
        out.indices = block + static_cast<int>(block[slot]);
        out.count = static_cast<int>(block[slot + 1]);
        slot += 2;
    } else if constexpr (requires { M::pack; }) {  // a text that a formula reads
        out.reals = block + static_cast<int>(block[slot]);
        out.count = static_cast<int>(block[slot + 1]);
        slot += 2;
    } else if constexpr (std::is_same_v<M, bool>) {
        out = block[slot++] != 0;
    } else if constexpr (std::is_same_v<M, int> || std::is_enum_v<M>) {
        out = static_cast<M>(static_cast<int>(block[slot++]));
    } else if constexpr (!requires { typename M::value_type; }) {  // texts and names are not packed
        out = M(block[slot++]);
    }
}

template <class M>
inline void store_member(const M& value, std::vector<double>& block) {
    static_assert(!is_point_list<M> && !is_choice_list<M>, "lists are packed by pack()");
    if constexpr (is_point<M>) {
        block.push_back(value.x);
        block.push_back(value.y);
    } else if constexpr (std::is_arithmetic_v<M> || std::is_enum_v<M>) {
        block.push_back(static_cast<double>(value));
    }  // texts and names are not packed
}

}  // namespace detail

/// A node may keep values computed once from its fields: `static constexpr auto derived()` returns a tuple of members
/// and `void derive()` fills them from the fields (in double); the formula then reads them like fields.
template <class T>
concept HasDerived = requires { T::derived(); };

template <class T>
constexpr int derived_count() {
    if constexpr (HasDerived<T>) return static_cast<int>(std::tuple_size_v<decltype(T::derived())>);
    else return 0;
}

/// Reals that the fields and derived values of T take at the head of its packed block.
template <class T>
inline int packed_size() {
    T node{};
    // Lists read their offset from the block: any real will do to be counted.
    [[maybe_unused]] static constexpr double zeros[256] = {};
    int slot = 0;
    static constexpr auto description = T::describe();
    std::apply([&](const auto&... f) { (detail::load_member(f.member, node, zeros, slot), ...); }, description.fields);
    return slot + derived_count<T>();
}

template <class T>
inline T load(const double* block) {
    T node{};
    int slot = 0;
    static constexpr auto description = T::describe();
    std::apply([&](const auto&... f) { (detail::load_member(f.member, node, block, slot), ...); }, description.fields);
    if constexpr (HasDerived<T>)
        std::apply([&](const auto&... member) { (detail::load_member(member, node, block, slot), ...); }, T::derived());
    return node;
}

/// The packed block of a node without lists, derived values included: what load() reads back.
template <class T>
inline std::vector<double> store(T node) {
    static constexpr auto description = T::describe();
    std::vector<double> block;
    std::apply([&](const auto&... f) { (detail::store_member(node.*f.member, block), ...); }, description.fields);
    if constexpr (HasDerived<T>) {
        node.derive();
        std::apply([&](const auto&... member) { (detail::store_member(node.*member, block), ...); }, T::derived());
    }
    return block;
}

/// Runs T::derive() on a block whose fields are packed and writes the derived values into it.
template <class T>
inline void derive_in_place(double* block) {
    if constexpr (HasDerived<T>) {
        T node = load<T>(block);
        node.derive();
        int slot = 0;
        T skipped{};
        static constexpr auto description = T::describe();
        std::apply([&](const auto&... f) { (detail::load_member(f.member, skipped, block, slot), ...); },
                   description.fields);
        std::apply([&](const auto&... member) { ((block[slot++] = node.*member), ...); }, T::derived());
    }
}

}  // namespace pinfield
