// Every code a diagnostic may carry: what people search for, what scenes/invalid/ names, what never changes its
// meaning.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "engine/core/diagnostic.h"

namespace pinfield {

/// E01xx the text and its limits, E02xx structure and values, E03xx references, E04xx not supported yet, W05xx doubts,
/// E06xx files that are not tables.
enum class Code : unsigned char {
    empty_file,
    not_utf8,
    control_character,
    tab_indentation,
    yaml_syntax,
    file_too_large,
    too_deep,
    too_many_events,
    scalar_too_long,
    too_many_nodes,
    too_many_points,
    too_many_repeats,
    cyclic_alias,
    alias_bomb,
    duplicate_key,
    merge_key,
    tag,
    several_documents,
    comment_ate_value,
    unknown_alias,
    bad_key,
    too_many_errors,
    expression_too_deep,
    expression_too_long,
    too_many_params,
    too_many_includes,
    table_too_large,

    wrong_shape,
    unknown_key,
    unknown_node,
    missing_version,
    unknown_version,
    wrong_type,
    missing_field,
    out_of_range,
    broken_contract,
    malformed_number,
    not_finite,
    unknown_unit,
    wrong_dimension,
    unknown_choice,
    unknown_color,
    missing_value,
    under_indented,
    not_one_key,
    child_count,
    misplaced_part,
    second_domain,
    bad_name,
    comma_split,
    bad_expectation,
    bad_expression,
    no_value,
    cyclic_param,
    cyclic_template,
    misplaced_copies,
    misplaced_section,
    cyclic_include,
    bad_path,
    no_distance,

    unknown_material,
    unknown_input,
    duplicate_id,
    unknown_quantity,
    unknown_name,
    unknown_template,
    unknown_argument,
    unreadable_include,

    motion_unsupported,
    game_unsupported,

    empty_scene,
    unknown_keyboard_key,
    offset_of_bound,
    idle_field,
    untouched_layer,
    start_in_solid,
    start_outside,
    start_in_drain,
    ball_too_large,
    pocket,
    empty_solid,
    no_boundary,
    unused_param,
    unused_template,

    unknown_step,
};

struct ErrorCode {
    std::string_view code;     ///< "E0202"; a warning's begins with W
    std::string_view name;     ///< "unknown_key"
    std::string_view meaning;  ///< one line for people
};

/// In the order of Code.
std::span<const ErrorCode> error_codes();
const ErrorCode& entry(Code code);

/// A diagnostic of this code; its severity is the code's.
Diagnostic diagnose(Code code, Place where, std::string message, std::string hint = {});

}  // namespace pinfield
