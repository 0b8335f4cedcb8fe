// What every command of `pinfield` shares: exit codes, the way it is added to the command line, and how it fails.
#pragma once
#include <string>
#include <string_view>

#include "engine/cli/arguments.h"
#include "engine/core/result.h"

namespace pinfield::cli {

/// What the shell sees.
enum class ExitCode : int {
    fine = 0,
    wrong = 1,   ///< the table is wrong, or a test failed
    usage = 2,   ///< the command line is wrong
    failed = 3,  ///< a file or a device failed
};

/// Ends a command from anywhere below it; main() tells why on stderr.
struct Stop {
    ExitCode code = ExitCode::failed;
    std::string message;   ///< a sentence, whatever is quoted in it; may be empty
    std::string findings;  ///< lines that are as people read them already: text_of()
};

/// The value of a result, or the end of the command with exit code 3.
template <class T>
T value_or_stop(Result<T> result) {
    if (!result) throw Stop{ExitCode::failed, result.error().message, ""};
    if constexpr (!std::is_void_v<T>) return std::move(*result);
}

/// Each adds its subcommand; when the user asks for it, the callback runs it and sets `exit`.
void add_check(const Command& app, ExitCode& exit);
void add_explain(const Command& app, ExitCode& exit);
void add_new(const Command& app, ExitCode& exit);
void add_nodes(const Command& app, ExitCode& exit);
void add_schema(const Command& app, ExitCode& exit);
void add_eval(const Command& app, ExitCode& exit);
void add_simulate(const Command& app, ExitCode& exit);
void add_render(const Command& app, ExitCode& exit);
void add_format(const Command& app, ExitCode& exit);
void add_expand(const Command& app, ExitCode& exit);
void add_test(const Command& app, ExitCode& exit);
void add_upgrade(const Command& app, ExitCode& exit);
void add_bench(const Command& app, ExitCode& exit);
void add_completion(const Command& app, ExitCode& exit);

}  // namespace pinfield::cli
