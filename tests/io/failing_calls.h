// A disk that fails: every call that this test program makes to the system for a file goes through here, and can be made to fail.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace pinfield::test {

enum class Fault : unsigned char { io_error, disk_full, interrupted, short_write };

/// While it lives, call `nth` (from 1; 0: none), or, `repeated`, every nth, fails. A short write writes half of what it should; other calls than
/// write are not short.
class FailingCalls {
public:
    FailingCalls(std::size_t nth, Fault fault, bool repeated = false);
    ~FailingCalls();
    FailingCalls(const FailingCalls&) = delete;
    FailingCalls& operator=(const FailingCalls&) = delete;

    std::size_t made() const { return calls().size(); }
    const std::vector<std::string>& calls() const;  ///< names of all that were made
    const std::string& failed() const;              ///< names of those that failed
};

}  // namespace pinfield::test
