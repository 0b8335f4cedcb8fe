// What is wrong (or doubtful) in the author's file, and where.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/source_text.h"

namespace pinfield {

enum class Severity : unsigned char { warning, error };

/// A step on the way to where a finding stands: a template that was used, a copy that was made, a file that was included.
struct Via {
    std::string what;  ///< "the template gear"
    Place where;       ///< where it was asked for
    std::string_view how = "asked for";
};

/// One finding in an author's file. Findings are collected, never only the first.
struct Diagnostic {
    std::string code;  ///< "E0203": see error_codes.h
    Severity severity = Severity::error;
    std::string message;  ///< what is wrong, one sentence without a full stop
    Place where;          ///< nowhere when the scene was not read from a text
    std::string hint;     ///< how to mend it; may be empty
    std::vector<Via> via{};  ///< from the innermost outwards; almost always empty
};

using Diagnostics = std::vector<Diagnostic>;

bool has_errors(const Diagnostics& diagnostics);

/// The whole way to a finding, from the innermost outwards: `via`, and the files that it and each step stand in, up to the table's own.
std::vector<Via> way_to(const Diagnostic& diagnostic, const Sources& sources);

/// `file:line:col: error: message [E0203]`, then the source line with a caret, the way to it, and the hint; only `error: ...` for one that stands nowhere.
/// What comes from the file or its name is harmless (shown.h), and the caret stands under its character nevertheless.
std::string format(const Diagnostic& diagnostic, const Sources& sources);

}  // namespace pinfield
