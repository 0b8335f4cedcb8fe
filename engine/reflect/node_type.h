// A node type as ordinary data: what every consumer (reader, inspector, schema, docs, tests) is written over.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/reflect/describe.h"
#include "engine/reflect/value.h"

namespace pinfield {

namespace sdf {
struct Kernels;  // what a shape or operation computes: engine/sdf/kernels.h
}
struct PartTraits;  // what a part is made of: engine/scene/part_traits.h
struct TextFault;   // what is wrong with a text: text_fault.h

/// Appends to a block what a formula reads of a text; nothing where the text is wrong.
using PackText = std::optional<TextFault>(std::string_view text, std::vector<double>& block);

struct FieldType {
    std::string_view key;
    FieldKind kind = FieldKind::number;
    FieldMeta meta;
    Value initial;
    std::vector<std::string_view> choices;  ///< of a `choice` or `choices`, in declaration order
    bool common = false;                    ///< one of the fields every scene node has (id, at, turn ...)
    PackText* pack_text = nullptr;          ///< of a text that a formula reads; null: texts are not packed
};

struct ContractType {
    std::string_view sentence;
    bool (*holds)(const double* params);  ///< over the packed block, see pack()
};

struct NodeType {
    NodeMeta meta;
    std::vector<FieldType> fields;  ///< the type's own, in the order of describe(); scene nodes then have the common ones
    std::vector<ContractType> contracts;
    int own_fields = 0;             ///< how many of `fields` are the type's own
    const sdf::Kernels* kernels = nullptr;  ///< shapes and operations only
    const PartTraits* part = nullptr;       ///< parts only

    std::string_view key() const { return meta.key; }
    /// Index into `fields`, or nothing.
    std::optional<int> find_field(std::string_view key) const;
};

/// Metres: a length is no longer than the one, and, where it must be above 0, no shorter than the other. Far beyond any table, and near
/// enough for squares and quotients of lengths to keep their digits.
inline constexpr double longest_length = 1e6, shortest_length = 1e-9;

/// First reason why a value may not stand in this field (range, choice, NaN, kind), as "must be above 0 m", or nothing.
std::optional<std::string> why_invalid(const FieldType& field, const Value& value);

/// The packed block of a node: one real per bool, int, number or choice (its index), two per vec2, and (offset, count) per list
/// of points, whose coordinates follow after `derived` further reals left 0 for the node's derive(), as does what a formula reads of a text.
/// Other texts, ids and names take none.
std::vector<double> pack(const NodeType& type, std::span<const Value> own_values, int derived = 0);

/// Sentence of the first contract the packed values break, or nothing. Ranges are checked by why_invalid().
std::optional<std::string_view> broken_contract(const NodeType& type, const double* params);

std::string_view name(NodeKind kind);
/// "m", "deg", "s", "kg", "m/s" ...; "" for none.
std::string_view symbol(Unit unit);

}  // namespace pinfield
