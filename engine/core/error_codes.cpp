#include "engine/core/error_codes.h"

#include <array>
#include <utility>

#include "engine/core/at.h"

namespace pinfield {
namespace {

constexpr std::array codes{
    ErrorCode{"E0101", "empty_file", "the file holds no table"},
    ErrorCode{"E0102", "not_utf8", "the text is not valid UTF-8"},
    ErrorCode{"E0103", "control_character", "a NUL or another control character stands in the text"},
    ErrorCode{"E0104", "tab_indentation", "a line is indented with a tab; YAML takes spaces only"},
    ErrorCode{"E0105", "yaml_syntax", "the text is not YAML"},
    ErrorCode{"E0106", "file_too_large", "the file is larger than the limit"},
    ErrorCode{"E0107", "too_deep", "the nesting is deeper than the limit"},
    ErrorCode{"E0108", "too_many_events", "the text has more YAML events than the limit"},
    ErrorCode{"E0109", "scalar_too_long", "one value is longer than the limit"},
    ErrorCode{"E0110", "too_many_nodes", "the table has more nodes than the limit"},
    ErrorCode{"E0111", "too_many_points", "a list of points is longer than the limit"},
    ErrorCode{"E0112", "too_many_repeats", "a repetition counts more copies than the limit"},
    ErrorCode{"E0113", "cyclic_alias", "an alias stands inside what it stands for"},
    ErrorCode{"E0114", "alias_bomb", "the aliases expand to more than the limits allow"},
    ErrorCode{"E0115", "duplicate_key", "a map says the same key twice"},
    ErrorCode{"E0116", "merge_key", "the merge key << is not part of the format"},
    ErrorCode{"E0117", "tag", "a !tag is not part of the format"},
    ErrorCode{"E0118", "several_documents", "the file holds more than one YAML document"},
    ErrorCode{"E0119", "comment_ate_value", "a blank and # begin a comment where a value was meant"},
    ErrorCode{"E0120", "unknown_alias", "an alias names no anchor above it"},
    ErrorCode{"E0121", "bad_key", "a key is not a plain word"},
    ErrorCode{"E0122", "too_many_errors", "there are more errors than anybody would read"},
    ErrorCode{"E0123", "expression_too_deep", "an expression has too many brackets within each other"},
    ErrorCode{"E0124", "expression_too_long", "an expression has too many parts"},
    ErrorCode{"E0125", "too_many_params", "the table has more params, or a template more arguments, than the limit"},
    ErrorCode{"E0126", "too_many_includes", "the table includes more files than the limit"},
    ErrorCode{"E0127", "table_too_large", "the table's files together are larger than the limit"},

    ErrorCode{"E0201", "wrong_shape", "a map, a list or a single value stands where another of them is due"},
    ErrorCode{"E0202", "unknown_key", "no such key here"},
    ErrorCode{"E0203", "unknown_node", "no node type of this name"},
    ErrorCode{"E0204", "missing_version", "the file does not say which version of the format it is in"},
    ErrorCode{"E0205", "unknown_version", "this version of the format is not known"},
    ErrorCode{"E0206", "wrong_type", "the value is of another type than the field"},
    ErrorCode{"E0207", "missing_field", "a field that has no default is missing"},
    ErrorCode{"E0208", "out_of_range", "the value lies outside its range"},
    ErrorCode{"E0209", "broken_contract", "the node's values contradict each other"},
    ErrorCode{"E0210", "malformed_number",
              "a number is written in a way that means different things to different people"},
    ErrorCode{"E0211", "not_finite", "a number is infinite or not a number"},
    ErrorCode{"E0212", "unknown_unit", "no such unit"},
    ErrorCode{"E0213", "wrong_dimension", "the unit measures something else"},
    ErrorCode{"E0214", "unknown_choice", "the word is none of those the field takes"},
    ErrorCode{"E0215", "unknown_color", "neither a CSS color name nor a quoted #rgb or #rrggbb"},
    ErrorCode{"E0216", "missing_value", "a key without a value"},
    ErrorCode{"E0217", "under_indented", "a node's fields are indented too little"},
    ErrorCode{"E0218", "not_one_key", "a node is a map with exactly one key"},
    ErrorCode{"E0219", "child_count", "the node takes more or fewer children"},
    ErrorCode{"E0220", "misplaced_part", "a part or group stands where only shapes and operations may"},
    ErrorCode{"E0221", "second_domain", "a layer has more than one domain"},
    ErrorCode{"E0222", "bad_name", "a name is not of the form [a-z_][a-z0-9_]*"},
    ErrorCode{"E0223", "comma_split", "a comma of the flow style split an expression"},
    ErrorCode{"E0224", "bad_expectation", "not of the form: quantity comparison number"},
    ErrorCode{"E0225", "bad_expression", "an expression that cannot be understood"},
    ErrorCode{"E0226", "no_value", "an expression that has no value here, such as a division by zero"},
    ErrorCode{"E0227", "cyclic_param", "params need each other in a circle"},
    ErrorCode{"E0228", "cyclic_template", "a template uses itself"},
    ErrorCode{"E0229", "misplaced_copies", "use, copies or pair stands inside a shape"},
    ErrorCode{"E0230", "misplaced_section", "an included file has a section that only the table's own file may have"},
    ErrorCode{"E0231", "cyclic_include", "files include each other in a circle"},
    ErrorCode{"E0232", "bad_path", "a path that no table may include"},
    ErrorCode{"E0233", "no_distance", "a formula that no distance can be made of"},

    ErrorCode{"E0301", "unknown_material", "no material of this name"},
    ErrorCode{"E0302", "unknown_input", "no input of this name"},
    ErrorCode{"E0303", "duplicate_id", "two things have the same id"},
    ErrorCode{"E0304", "unknown_quantity", "nothing by this name is measured"},
    ErrorCode{"E0305", "unknown_name", "no param, argument or other number of this name"},
    ErrorCode{"E0306", "unknown_template", "no template of this name"},
    ErrorCode{"E0307", "unknown_argument", "the template takes no argument of this name"},
    ErrorCode{"E0308", "unreadable_include", "an included file is not there, or cannot be read"},

    ErrorCode{"E0407", "motion_unsupported", "motions are not supported yet"},
    ErrorCode{"E0409", "game_unsupported", "game rules are not supported yet"},

    ErrorCode{"W0501", "empty_scene", "the table has no scene"},
    ErrorCode{"W0502", "unknown_keyboard_key", "no key of a keyboard has this name"},
    ErrorCode{"W0503", "offset_of_bound", "round, inset or onion of a distance that is only a bound"},
    ErrorCode{"W0504", "idle_field", "a field that does nothing beside the node's other values"},
    ErrorCode{"W0505", "untouched_layer", "a solid on a layer that no ball is on"},
    ErrorCode{"W0506", "start_in_solid", "a ball that is to start would overlap something solid"},
    ErrorCode{"W0507", "start_outside", "a ball is to start where the domain says that none may be"},
    ErrorCode{"W0508", "start_in_drain", "a ball is to start in a drain"},
    ErrorCode{"W0509", "ball_too_large", "a ball is too large for the whole table"},
    ErrorCode{"W0510", "pocket", "a place where slow balls come to rest and nothing plays them"},
    ErrorCode{"W0511", "empty_solid", "a solid of which nothing is left"},
    ErrorCode{"W0512", "no_boundary", "a solid whose boundary could not be found, so that its formula must do"},
    ErrorCode{"W0513", "unused_param", "a param that nothing depends on"},
    ErrorCode{"W0514", "unused_template", "a template that nothing uses"},

    ErrorCode{"E0601", "unknown_step", "no such step in an editor script"},
};

static_assert(codes.size() == static_cast<std::size_t>(Code::unknown_step) + 1,
              "one entry per code, in the order of Code");

}  // namespace

std::span<const ErrorCode> error_codes() { return codes; }

const ErrorCode& entry(Code code) { return at(codes, code); }

Diagnostic diagnose(Code code, Place where, std::string message, std::string hint) {
    const std::string_view word = entry(code).code;
    const Severity severity = word.front() == 'W' ? Severity::warning : Severity::error;
    return {std::string(word), severity, std::move(message), where, std::move(hint)};
}

}  // namespace pinfield
