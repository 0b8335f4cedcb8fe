// From a described struct to a NodeType, and from a packed block back to the struct.
#pragma once
#include <array>
#include <cassert>
#include <concepts>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include "engine/core/at.h"
#include "engine/reflect/load.h"
#include "engine/reflect/node_type.h"

namespace pinfield {

/// An enum that a field may hold gives its words, in order, by `constexpr std::array<std::string_view, N> choice_names(E)`.
template <class E>
concept Choice = std::is_enum_v<E> && requires(E e) { choice_names(e); };

/// A text that a formula reads says how: `static PackText pack`; and, as a member's initialiser, what it is by default: `text`.
template <class M>
concept PackedText = requires(const M& member) {
    static_cast<PackText*>(M::pack);
    std::string(member.text);
};

namespace detail {

template <class M>
FieldKind kind_of(Meaning meaning) {
    if constexpr (std::is_same_v<M, bool>) return FieldKind::boolean;
    else if constexpr (std::is_same_v<M, int>) return FieldKind::integer;
    else if constexpr (std::is_same_v<M, double>) return FieldKind::number;
    else if constexpr (std::is_same_v<M, Point<double>>) return FieldKind::vec2;
    else if constexpr (std::is_same_v<M, PointList<double>>) return FieldKind::points;
    else if constexpr (Choice<M>) return FieldKind::choice;
    else if constexpr (is_choice_list<M>) return FieldKind::choices;
    else if constexpr (std::is_same_v<M, std::vector<std::string>>) return FieldKind::names;
    else if constexpr (PackedText<M>) return FieldKind::text;
    else {
        static_assert(std::is_same_v<M, std::string>, "a field is bool, int, double, Point, PointList, enum, ChoiceList or text");
        return meaning == Meaning::color                                 ? FieldKind::color
               : meaning == Meaning::id || meaning == Meaning::material ? FieldKind::id
                                                                        : FieldKind::text;
    }
}

template <class M>
Value value_of(const M& member) {
    if constexpr (std::is_same_v<M, int>) return static_cast<std::int64_t>(member);
    else if constexpr (std::is_same_v<M, Point<double>>) return Vec2(member.x, member.y);
    else if constexpr (std::is_same_v<M, PointList<double>>) {
        std::vector<Vec2> points;
        for (int i = 0; i < member.count; ++i) points.emplace_back(member[i].x, member[i].y);
        return points;
    } else if constexpr (Choice<M>) {
        return std::string(at(choice_names(member), member));
    } else if constexpr (is_choice_list<M>) {
        std::vector<std::string> words;
        for (int i = 0; i < member.count; ++i) words.emplace_back(at(choice_names(member[i]), member[i]));
        return words;
    } else if constexpr (PackedText<M>) {
        return std::string(member.text);
    } else {
        return member;
    }
}

template <class T, std::size_t I>
FieldType erase_field(const T& defaults) {
    constexpr auto description = T::describe();
    constexpr auto f = std::get<I>(description.fields);
    using M = std::remove_cvref_t<decltype(defaults.*f.member)>;
    // Built in place: assigned later, the inlined temporary looks to GCC 12 like memory freed that was never allocated.
    FieldType out{f.key, kind_of<M>(f.meta.meaning), f.meta, value_of(defaults.*f.member), {}, false, nullptr};
    if constexpr (PackedText<M>) out.pack_text = M::pack;
    if constexpr (Choice<M>)
        for (const std::string_view word : choice_names(M{})) out.choices.push_back(word);
    if constexpr (is_choice_list<M>)
        for (const std::string_view word : choice_names(decltype(M{}[0]){})) out.choices.push_back(word);
    return out;
}

template <class T, std::size_t I>
ContractType erase_contract() {
    constexpr auto description = T::describe();
    return {std::get<I>(description.contracts).sentence, [](const double* params) {
                constexpr auto d = T::describe();
                return std::get<I>(d.contracts).holds(load<T>(params));
            }};
}

}  // namespace detail

/// The description of T as data; the defaults are T's own member initialisers.
template <class T>
NodeType node_type() {
    constexpr auto description = T::describe();
    NodeType type;
    type.meta = description.meta;
    const T defaults{};
    [&]<std::size_t... I>(std::index_sequence<I...>) { (type.fields.push_back(detail::erase_field<T, I>(defaults)), ...); }
    (std::make_index_sequence<std::tuple_size_v<decltype(description.fields)>>{});
    [&]<std::size_t... I>(std::index_sequence<I...>) { (type.contracts.push_back(detail::erase_contract<T, I>()), ...); }
    (std::make_index_sequence<std::tuple_size_v<decltype(description.contracts)>>{});
    type.own_fields = static_cast<int>(type.fields.size());
    return type;
}

/// The values of a described struct's fields, in the order of describe().
template <class T>
std::vector<Value> values_of(const T& node) {
    constexpr auto description = T::describe();
    std::vector<Value> out;
    std::apply([&](const auto&... f) { (out.push_back(detail::value_of(node.*f.member)), ...); }, description.fields);
    return out;
}

}  // namespace pinfield
