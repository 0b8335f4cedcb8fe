// How a node describes itself: key, fields, contract and exactness, once, beside its formula.
// constexpr throughout: a description costs nothing until `node_type<T>()` (erase.h) turns it into ordinary data.
#pragma once
#include <limits>
#include <string_view>
#include <tuple>

#include "engine/core/point.h"
#include "engine/reflect/exactness.h"

namespace pinfield {

enum class Unit : unsigned char {
    none,
    metre,
    degree,
    second,
    kilogram,
    metre_per_second,
    metre_per_second2,
    degree_per_second,
    degree_per_second2,
    seconds_per_metre
};

/// One end of a range; `open` leaves the value itself out.
struct Limit {
    double value;
    bool open;
};
constexpr Limit above(double v) { return {v, true}; }
constexpr Limit below(double v) { return {v, true}; }
constexpr Limit from(double v) { return {v, false}; }
constexpr Limit to(double v) { return {v, false}; }

/// What a field's value stands for beyond its kind. id: the node's own name. material, input, layer: names of such. count: how many
/// copies an operation makes, which costs as many. place: a point, or points, of the node's own frame, for a hand to take hold of. formula: a
/// text that is an expression of the node's own x and y, and a length.
enum class Meaning : unsigned char { plain, color, id, material, input, layer, count, place, formula };

/// What an edit of the field changes of a compiled table. structure: what is counted over the whole table (names, layers). shape: the
/// node and what it belongs to. drawing: only how it looks. nothing: what is for people and tools.
enum class Affects : unsigned char { structure, shape, drawing, nothing };

/// The field means something only where the node's choice `field` is `choice`; always when empty.
struct OnlyWith {
    std::string_view field{}, choice{};
};

/// Ranges hold for every component of a vec2 and every point of a list.
struct FieldMeta {
    Unit unit = Unit::none;
    Limit min = from(-std::numeric_limits<double>::infinity());
    Limit max = to(std::numeric_limits<double>::infinity());
    double step = 0;        ///< of a drag in the editor, in file units; 0 lets the editor choose
    bool required = false;  ///< true: the author must say it, there is no default
    Meaning meaning = Meaning::plain;
    Affects affects = Affects::shape;
    OnlyWith only_with{};
    std::string_view doc{};
};

template <class T, class M>
struct FieldDescription {
    std::string_view key;
    M T::*member;
    FieldMeta meta;
};
template <class T, class M>
constexpr FieldDescription<T, M> field(std::string_view key, M T::*member, FieldMeta meta) {
    return {key, member, meta};
}

/// A relation between the fields of one node that must hold, such as "w >= h". `Holds` is a generic lambda over the node, so
/// that nothing of it is compiled for a SIMD scalar.
template <class Holds>
struct Contract {
    std::string_view sentence;
    Holds holds;
};
template <class Holds>
constexpr Contract<Holds> contract(std::string_view sentence, Holds holds) {
    return {sentence, holds};
}

enum class NodeKind : unsigned char { shape, operation, part, record };

/// How many children a node takes.
struct ChildCount {
    int min = 0;
    int max = 0;
};
inline constexpr int any_number = std::numeric_limits<int>::max();

struct NodeMeta {
    std::string_view key{};
    NodeKind kind = NodeKind::record;
    Exactness exactness{};  ///< at good parameters and, for an operation, with exact children
    /// |float packet - double| <= float_error * max(|p|, extent of the shape), in both the worst and the usual case.
    double float_error = 1e-6;
    ChildCount children{};
    std::string_view doc{};
};

template <class T, class Fields, class Contracts>
struct Description {
    NodeMeta meta;
    Fields fields;
    Contracts contracts;
};

template <class... F>
constexpr std::tuple<F...> fields(F... f) {
    return {f...};
}

/// A primitive solid: `describe()` of a struct with `Real distance(const Point<Real>&) const`.
template <class T, class... F, class... C>
constexpr Description<T, std::tuple<F...>, std::tuple<C...>> shape(NodeMeta meta, std::tuple<F...> f, C... c) {
    meta.kind = NodeKind::shape;
    return {meta, f, {c...}};
}
/// A node over its children: CSG, blends, offsets, symmetries.
template <class T, class... F, class... C>
constexpr Description<T, std::tuple<F...>, std::tuple<C...>> operation(NodeMeta meta, std::tuple<F...> f, C... c) {
    meta.kind = NodeKind::operation;
    return {meta, f, {c...}};
}
/// A mechanism of the table.
template <class T, class... F, class... C>
constexpr Description<T, std::tuple<F...>, std::tuple<C...>> part(NodeMeta meta, std::tuple<F...> f, C... c) {
    meta.kind = NodeKind::part;
    return {meta, f, {c...}};
}
/// A described struct that is not a scene node: a material, the table's own data.
template <class T, class... F, class... C>
constexpr Description<T, std::tuple<F...>, std::tuple<C...>> record(NodeMeta meta, std::tuple<F...> f, C... c) {
    meta.kind = NodeKind::record;
    return {meta, f, {c...}};
}

}  // namespace pinfield
